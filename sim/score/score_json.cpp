#include "sim/score/score_json.h"

#include <nlohmann/json.hpp>

namespace eod::sim {
namespace {

using Json = nlohmann::ordered_json;

Json ToJson(const ScoreItem& item) {
  Json json{{"item", item.name}, {"text", item.text}, {"taken", item.is_taken}};
  json["amount"] = item.is_taken ? Json(item.amount) : Json(nullptr);
  json["unit"] = item.unit;
  json["points"] = item.points;
  json["of"] = item.of;
  return json;
}

Json ToJson(const ScorePart& part) {
  Json items = Json::array();
  for (const ScoreItem& item : part.items) items.push_back(ToJson(item));
  return {{"part", part.name}, {"points", part.points}, {"of", part.of}, {"items", items}};
}

Json ToJson(const SheetProcedure& line) {
  return {{"item", line.name},
          {"text", line.text},
          {"result", line.result},
          {"t", line.time_s < 0 ? Json(nullptr) : Json(line.time_s)},
          {"points", line.points}};
}

Json ToJson(const SheetEvent& event) {
  return {{"t", event.time_s},        {"part", event.part},     {"item", event.name},
          {"text", event.text},       {"points", event.points}, {"x_m", event.position.x()},
          {"y_m", event.position.y()}};
}

template <typename One>
Json ListOf(const One& list) {
  Json json = Json::array();
  for (const auto& one : list) json.push_back(ToJson(one));
  return json;
}

}  // namespace

std::string ToJson(const ScoreSheet& sheet) {
  const Json failure =
      sheet.critical_failure.empty() ? Json(nullptr) : Json(sheet.critical_failure);
  const Json json{{"scenario", sheet.scenario},
                  {"title", sheet.title},
                  {"module", sheet.module_name},
                  {"difficulty", sheet.difficulty},
                  {"seed", sheet.seed},
                  {"result", sheet.result},
                  {"critical_failure", failure},
                  {"passed", sheet.passed},
                  {"total", sheet.total},
                  {"pass", sheet.pass},
                  {"elapsed_s", sheet.elapsed_s},
                  {"par_time_s", sheet.par_time_s},
                  {"steps_done", sheet.steps_done},
                  {"steps", sheet.steps},
                  {"lost_s", sheet.lost_s},
                  {"parts", ListOf(sheet.parts)},
                  {"procedure", ListOf(sheet.procedure)},
                  {"events", ListOf(sheet.events)},
                  {"events_left_out", sheet.events_left_out}};
  return json.dump(2) + "\n";
}

}  // namespace eod::sim
