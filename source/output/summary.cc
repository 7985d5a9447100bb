// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/first_rank.h>
#include <semilunar/output/atomic_file.h>
#include <semilunar/output/summary.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <sstream>

namespace semilunar::output
{
  namespace
  {
    std::string json(const std::string &text)
    {
      std::string result = "\"";
      for (const unsigned char c : text)
        if (c == '"' || c == '\\')
          result += {'\\', static_cast<char>(c)};
        else if (c < 0x20)
        {
          char escape[7];
          std::snprintf(escape, sizeof(escape), "\\u%04x", c);
          result += escape;
        }
        else
          result += c;
      return result + "\"";
    }

    std::string json(const double number)
    {
      if (!std::isfinite(number))
        return "null";
      std::ostringstream text;
      text.precision(std::numeric_limits<double>::max_digits10);
      text << number;
      return text.str();
    }

    std::string json(const Quantity &quantity)
    {
      std::string result =
          "{\"value\": " + json(quantity.value) + ", \"unit\": " + json(quantity.unit);
      const auto add_if_known = [&](const std::string &name, const double number)
      {
        if (!std::isnan(number))
          result += ", " + json(name) + ": " + json(number);
      };
      add_if_known("reference", quantity.reference);
      add_if_known("error", quantity.error);
      add_if_known("order", quantity.order);
      return result + "}";
    }

    /// The members of an object, one per line.
    class Object
    {
    public:
      explicit Object(const std::string &indent) : indent(indent) {}

      void add(const std::string &name, const std::string &value)
      {
        members += (members.empty() ? "\n" : ",\n") + indent + "  " + json(name) + ": " + value;
      }

      std::string str() const
      {
        return members.empty() ? "{}" : "{" + members + "\n" + indent + "}";
      }

    private:
      const std::string indent;
      std::string members;
    };
  } // namespace

  std::string to_json(const Summary &summary)
  {
    Object quantities("  ");
    for (const Quantity &quantity : summary.results.quantities)
      quantities.add(quantity.name, json(quantity));
    Object cost("  ");
    cost.add("wall_s", json(summary.cost.wall_seconds));
    cost.add("cpu_s", json(summary.cost.cpu_seconds));
    cost.add("peak_memory_mib", json(summary.cost.peak_memory_mib));
    cost.add("unknowns", std::to_string(summary.results.unknowns));
    cost.add("steps", std::to_string(summary.results.steps));
    cost.add("newton_iterations", std::to_string(summary.results.newton_iterations));
    Object phases("  ");
    for (const auto &[name, seconds] : summary.phases)
      phases.add(name, json(seconds));

    Object all("");
    all.add("scene", json(summary.scene));
    all.add("quantities", quantities.str());
    all.add("cost", cost.str());
    all.add("phases", phases.str());
    all.add("version", json(summary.version));
    return all.str() + "\n";
  }

  void write_summary(const std::filesystem::path &folder, const Summary &summary)
  {
    on_first_rank(
        [&]()
        {
          write_atomically((folder / "summary.json").string(),
                           [&](std::ostream &out) { out << to_json(summary); });
        });
  }
} // namespace semilunar::output
