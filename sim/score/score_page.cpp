#include "sim/score/score_page.h"

#include <cmath>

#include <fmt/format.h>

namespace eod::sim {
namespace {

constexpr std::string_view kStyle = R"(
:root{--ink:#1c2430;--soft:#66707f;--line:#dde2e9;--good:#1a7f4b;--bad:#b3261e;--mid:#b26a00;--bar:#2f6fb0}
*{box-sizing:border-box}
body{margin:0;background:#eef1f5;color:var(--ink);font:15px/1.45 system-ui,"Liberation Sans",Arial,sans-serif}
main{max-width:860px;margin:24px auto;background:#fff;border-radius:10px;padding:30px 40px 36px;box-shadow:0 1px 8px #0002}
h1{font-size:26px;margin:0 0 2px}
h2{font-size:17px;margin:30px 0 8px;border-bottom:2px solid var(--ink);padding-bottom:3px}
.sub{color:var(--soft);margin:0}
.verdict{display:flex;align-items:center;gap:22px;margin:20px 0 4px;padding:16px 22px;border-radius:8px;color:#fff}
.verdict.pass{background:var(--good)}.verdict.fail{background:var(--bad)}.verdict.open{background:#5b6575}
.verdict b{font-size:30px;letter-spacing:.04em}.verdict span{flex:1}
.verdict strong{font-size:40px;font-variant-numeric:tabular-nums}.verdict small{font-size:16px;opacity:.85}
.part{margin:14px 0 4px;break-inside:avoid}
.head{display:grid;grid-template-columns:120px 1fr 110px;gap:14px;align-items:center;font-weight:600}
.head span:last-child{text-align:right;font-variant-numeric:tabular-nums}
.track{height:14px;background:#e6eaf0;border-radius:7px;overflow:hidden}.track i{display:block;height:100%;background:var(--bar)}
table{width:100%;border-collapse:collapse;font-size:14px}
td,th{padding:3px 8px;text-align:left;vertical-align:top;border-bottom:1px solid var(--line)}
th{color:var(--soft);font-weight:600;font-size:12.5px}
.n{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}
.part table{margin-left:12px;width:calc(100% - 12px);table-layout:fixed}.part td:nth-child(2){width:130px}.part td:nth-child(3){width:120px}.part tr:last-child td{border:0}
.zero td{color:var(--soft)}.good{color:var(--good)}.bad{color:var(--bad)}.open{color:var(--mid)}
.warn{background:#fff4e0;border-left:4px solid var(--mid);padding:8px 14px;margin:14px 0 0}
svg{width:100%;height:auto;background:#f8fafc;border:1px solid var(--line);border-radius:6px}
.grid path{stroke:#e4e9f0;stroke-width:1}.scale path{stroke:var(--ink);stroke-width:3}
.scale text,.place text{font-size:12px;fill:var(--soft)}.place rect{fill:#fff;stroke:#7a8496;stroke-width:1.5}
.place text{fill:var(--ink)}.way{fill:none;stroke:var(--bar);stroke-width:2.5;stroke-linejoin:round;opacity:.8}
.start{fill:#fff;stroke:var(--bar);stroke-width:3}.end{fill:var(--bar)}
.mark text{font-size:10px;font-weight:700;fill:#fff;text-anchor:middle}
.mark.good circle{fill:var(--good)}.mark.bad circle{fill:var(--bad)}
.legend{color:var(--soft);font-size:13px;margin:4px 0 0}
@media print{body{background:#fff}main{box-shadow:none;margin:0;max-width:none;padding:0}
.verdict,.track,.track i,svg *{print-color-adjust:exact;-webkit-print-color-adjust:exact}}
)";

/// Points with a sign where they are lost, and a nought without.
std::string Points(double points) {
  const double rounded = std::round(points * 100) / 100;
  if (rounded == 0) return "0";
  return fmt::format("{}{:.4g}", rounded < 0 ? "\u2212" : "", std::abs(rounded));
}

std::string Clock(double seconds) {
  const auto tenths = static_cast<int64_t>(std::floor(seconds * 10));
  return fmt::format("{}:{:02}.{}", tenths / 600, tenths / 10 % 60, tenths % 10);
}

std::string Verdict(const ScoreSheet& sheet) {
  std::string_view look = "fail", word = "NOT PASSED";
  std::string why = fmt::format("{} of {} steps complete", sheet.steps_done, sheet.steps);
  if (sheet.passed) {
    look = "pass";
    word = "PASSED";
  } else if (!sheet.critical_failure.empty()) {
    why = fmt::format("Critical failure: {}. {}", EscapeHtml(sheet.critical_failure), why);
  } else if (sheet.result != "success") {
    if (sheet.result != "abort") look = "open";
    if (sheet.result != "abort") word = "INCOMPLETE";
    if (sheet.result == "abort") why = "Ended before its end. " + why;
  } else {
    why += fmt::format(", but {} points are needed", Points(sheet.pass));
  }
  return fmt::format(
      "<div class=\"verdict {}\"><b>{}</b><span>{}<br><small>{} points pass; time {}"
      "</small></span><strong>{}<small> / 100</small></strong></div>\n",
      look, word, why, Points(sheet.pass), Clock(sheet.elapsed_s), Points(sheet.total));
}

std::string Amount(const ScoreItem& item) {
  if (item.name == "step") return item.is_taken ? "done" : "\u2013";
  if (!item.is_taken) return "not measured";
  if (item.unit == "m") return fmt::format("{:.3f} m", item.amount);
  if (!item.unit.empty()) return fmt::format("{:.1f} {}", item.amount, item.unit);
  return fmt::format("{:.4g}", item.amount);
}

std::string Part(const ScorePart& part) {
  const double share = part.of > 0 ? 100 * part.points / part.of : 0;
  std::string html = fmt::format(
      "<div class=\"part\"><div class=\"head\"><span>{}</span><div class=\"track\"><i "
      "style=\"width:{:.1f}%\"></i></div><span>{} / {}</span></div>\n<table>",
      part.text, share, Points(part.points), Points(part.of));
  for (const ScoreItem& item : part.items) {
    const bool is_nothing = item.points == 0 && item.of == 0;
    const std::string of = item.of > 0 ? fmt::format(" / {}", Points(item.of)) : "";
    html +=
        fmt::format("<tr{}><td>{}</td><td class=\"n\">{}</td><td class=\"n{}\">{}{}</td></tr>\n",
                    is_nothing ? " class=\"zero\"" : "", EscapeHtml(item.text), Amount(item),
                    item.points < 0 ? " bad" : "", Points(item.points), of);
  }
  return html + "</table></div>\n";
}

std::string Procedure(const std::vector<SheetProcedure>& lines) {
  if (lines.empty()) return {};
  std::string html =
      "<h2>Check list</h2>\n<table><tr><th>Item</th><th>Result</th><th class=\"n\">Time</th>"
      "<th class=\"n\">Points</th></tr>\n";
  for (const SheetProcedure& line : lines) {
    const bool is_good = line.result == "done" || line.result == "kept";
    html += fmt::format(
        "<tr><td>{}</td><td class=\"{}\">{} {}</td><td class=\"n\">{}</td>"
        "<td class=\"n\">{}</td></tr>\n",
        EscapeHtml(line.text),
        is_good           ? "good"
        : line.points < 0 ? "bad"
                          : "open",
        is_good           ? "\u2713"
        : line.points < 0 ? "\u2717"
                          : "\u2026",
        line.result, line.time_s < 0 ? "" : Clock(line.time_s), Points(line.points));
  }
  return html + "</table>\n";
}

std::string Events(const ScoreSheet& sheet) {
  std::string html =
      "<h2>What happened</h2>\n<table><tr><th class=\"n\">No.</th><th class=\"n\">Time</th>"
      "<th>Part</th><th>Event</th><th class=\"n\">Points</th></tr>\n";
  for (size_t i = 0; i < sheet.events.size(); ++i) {
    const SheetEvent& event = sheet.events[i];
    const bool is_bad = event.points < 0 || event.part == "failure";
    html += fmt::format(
        "<tr><td class=\"n\">{}</td><td class=\"n\">{}</td><td>{}</td><td>{}</td>"
        "<td class=\"n {}\">{}</td></tr>\n",
        i + 1, Clock(event.time_s), event.part, EscapeHtml(event.text),
        is_bad             ? "bad"
        : event.points > 0 ? "good"
                           : "",
        event.points == 0 ? "" : Points(event.points));
  }
  if (sheet.events_left_out > 0) {
    html += fmt::format("<tr><td></td><td></td><td></td><td>and {} more</td><td></td></tr>\n",
                        sheet.events_left_out);
  }
  return html + "</table>\n";
}

std::string Map(const ScoreSheet& sheet) {
  const std::string map = ToMap(sheet);
  if (map.empty()) return {};
  return "<h2>The robot's way</h2>\n" + map +
         "\n<p class=\"legend\">From the open to the full circle. Numbers are those of the events: "
         "<span class=\"good\">points gained</span>, <span class=\"bad\">points lost</span>.</p>\n";
}

}  // namespace

std::string EscapeHtml(const std::string& text) {
  std::string html;
  for (const char c : text) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

std::string ToPage(const ScoreSheet& sheet) {
  const std::string title = EscapeHtml(sheet.title.empty() ? sheet.scenario : sheet.title);
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title>\n"
      "<style>{1}</style></head><body><main>\n<h1>{0}</h1>\n<p class=\"sub\">{2} \u00b7 module {3} "
      "\u00b7 difficulty {4} of 5 \u00b7 par {5} \u00b7 seed {6}</p>\n",
      title, kStyle, EscapeHtml(sheet.scenario), EscapeHtml(sheet.module_name), sheet.difficulty,
      sheet.par_time_s > 0 ? Clock(sheet.par_time_s) : "none", sheet.seed);
  html += Verdict(sheet);
  if (sheet.lost_s > 0) {
    html += fmt::format(
        "<p class=\"warn\">The record lacks {:.3g} s of the mission: this is not the "
        "score of the whole run.</p>\n",
        sheet.lost_s);
  }
  html += "<h2>Points</h2>\n";
  for (const ScorePart& part : sheet.parts) html += Part(part);
  html += Procedure(sheet.procedure) + Map(sheet) + Events(sheet);
  return html + "</main></body></html>\n";
}

}  // namespace eod::sim
