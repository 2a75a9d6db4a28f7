#include "engine/analysis/scheduling/gantt.h"

#include "engine/support/text.h"

#include <algorithm>
#include <fmt/format.h>
#include <ostream>

namespace symreal {
namespace {

constexpr double width = 960, row_height = 24, bar_height = 18, top = 40, narrow = 1.5;

struct Bar {
  Time begin, end;
  TaskId first;
  std::size_t tasks;
};

class Gantt {
public:
  Gantt(std::ostream &out, TaskGraph const &graph, Timetable const &timetable, GanttNames const &names)
      : out_(out),
        graph_(graph),
        timetable_(timetable),
        names_(names) {
    length_ = std::max(length(graph, timetable.start), Time{1});
    std::size_t longest = 0;
    for (std::string const &name : names.unit) longest = std::max(longest, name.size());
    left_ = 20 + 7 * static_cast<double>(longest);
  }

  void write() {
    double const height = top + row_height * static_cast<double>(names_.unit.size()) + 10;
    out_ << fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
                        "height=\"{1:.0f}\">\n",
                        left_ + width + 30, height);
    out_ << "<style>\n"
            ".page { fill: #ffffff } .line { stroke: #cccccc } .row { fill: #f2f2f2 }\n"
            "text { font: 11px sans-serif; fill: #222222 } .in { text-anchor: middle; fill: #111111 }\n"
            ".k0 { fill: #8fb8de } .k1 { fill: #f0b67f } .k2 { fill: #a5d6a7 } .k3 { fill: #d7aefb }\n"
            "rect.bar { stroke: #ffffff; stroke-width: 0.5 } rect.bar:hover { stroke: #222222; stroke-width: 1.5 }\n"
            "@media (prefers-color-scheme: dark) {\n"
            ".page { fill: #1b1b1b } .line { stroke: #555555 } .row { fill: #2a2a2a } text { fill: #dddddd }\n"
            "rect.bar { stroke: #1b1b1b } rect.bar:hover { stroke: #ffffff }\n"
            "}\n</style>\n";
    out_ << fmt::format("<rect class=\"page\" width=\"100%\" height=\"100%\"/>\n<text x=\"10\" y=\"14\">{}</text>\n",
                        escaped_xml(names_.title));
    write_axis(height);
    auto const bars = bars_of_units();
    for (std::size_t unit = 0; unit < bars.size(); ++unit) write_row(unit, bars[unit]);
    out_ << "</svg>\n";
  }

private:
  double x(Time at) const { return left_ + width * static_cast<double>(at) / static_cast<double>(length_); }

  // Draws at most ten lines at round times.
  void write_axis(double height) {
    Time step = 1;
    for (int i = 0; length_ > 10 * step; ++i) step = i % 3 == 1 ? step / 2 * 5 : step * 2; // 1, 2, 5, 10, 20, 50
    for (Time at = 0; at <= length_; at += step)
      out_ << fmt::format("<line class=\"line\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.0f}\" y2=\"{2:.0f}\"/>"
                          "<text x=\"{0:.1f}\" y=\"{3:.0f}\" text-anchor=\"middle\">{4}</text>\n",
                          x(at), top - 6, height - 6, top - 10, at);
  }

  std::vector<std::vector<Bar>> bars_of_units() const {
    std::vector<std::vector<Bar>> bars(names_.unit.size());
    for (TaskId task = 0; task < graph_.size(); ++task)
      if (graph_.duration[task] != 0)
        bars[timetable_.unit[task]].push_back(
            {timetable_.start[task], timetable_.start[task] + graph_.duration[task], task, 1});
    for (std::vector<Bar> &unit : bars) {
      std::ranges::sort(unit, {}, &Bar::begin);
      std::vector<Bar> merged;
      for (Bar const &bar : unit) {
        if (!merged.empty() && is_narrow(bar) && is_narrow(merged.back()) && x(bar.begin) - x(merged.back().end) < 1) {
          merged.back().end = bar.end;
          merged.back().tasks += bar.tasks;
        } else {
          merged.push_back(bar);
        }
      }
      unit = std::move(merged);
    }
    return bars;
  }
  // Merging widens a bar up to a size that can be pointed at.
  bool is_narrow(Bar const &bar) const { return x(bar.end) - x(bar.begin) < (bar.tasks == 1 ? narrow : 4 * narrow); }

  void write_row(std::size_t unit, std::vector<Bar> const &bars) {
    double const y = top + row_height * static_cast<double>(unit);
    out_ << fmt::format("<rect class=\"row\" x=\"{:.1f}\" y=\"{:.0f}\" width=\"{:.0f}\" height=\"{:.0f}\"/>"
                        "<text x=\"10\" y=\"{:.0f}\">{}</text>\n",
                        left_, y, width, bar_height, y + 13, escaped_xml(names_.unit[unit]));
    for (Bar const &bar : bars) {
      double const bar_width = x(bar.end) - x(bar.begin);
      std::string const &name = names_.task[bar.first];
      std::string const what = bar.tasks == 1 ? name : fmt::format("{} tasks", bar.tasks);
      out_ << fmt::format("<rect class=\"bar k{}\" x=\"{:.2f}\" y=\"{:.0f}\" width=\"{:.2f}\" height=\"{:.0f}\">"
                          "<title>{}: {} to {}</title></rect>",
                          graph_.kind.empty() ? 0 : graph_.kind[bar.first] % 4, x(bar.begin), y, bar_width, bar_height,
                          escaped_xml(what), bar.begin, bar.end);
      if (bar.tasks == 1 && bar_width > 8 + 7 * static_cast<double>(name.size()))
        out_ << fmt::format("<text class=\"in\" pointer-events=\"none\" x=\"{:.2f}\" y=\"{:.0f}\">{}</text>",
                            x(bar.begin) + bar_width / 2, y + 13, escaped_xml(name));
      out_ << "\n";
    }
  }

  std::ostream &out_;
  TaskGraph const &graph_;
  Timetable const &timetable_;
  GanttNames const &names_;
  Time length_;
  double left_;
};

} // namespace

void write_gantt(std::ostream &out, TaskGraph const &graph, Timetable const &timetable, GanttNames const &names) {
  Gantt(out, graph, timetable, names).write();
}

} // namespace symreal
