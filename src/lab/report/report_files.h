// The numbers of a report as files: CSV (RFC 4180) of plots and tables, JSON of everything.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "lab/report/report_layout.h"

namespace weft::lab {

/// "series,X,Y" and a line for every point of every series, in their order, with the axes' labels
/// as headings. Every number reads back as the same double; those not finite are inf, -inf, nan.
std::string plot_csv(const Plot& plot);

/// The headings, then a line a row. A cell without a value is empty.
std::string table_csv(const Table& table);

/// Everything that a report says, in the order of the page. Numbers that are not finite are null in
/// points and findings, and "inf", "-inf" or "nan" in tables, where null is a cell without a value.
nlohmann::ordered_json report_json(const ReportHead& head,
                                   std::span<const PlacedExperiment> experiments);

}  // namespace weft::lab
