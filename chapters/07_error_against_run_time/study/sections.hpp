#pragma once
// What the parts of chapter 7's program share.

#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "contest/contest.hpp"
#include "lab.hpp"

inline constexpr double pi = std::numbers::pi;

using All = std::map<std::string, std::vector<contest::Point>>;  // by the scene's id

All diagrams(const contest::Effort&, lab::Findings&);  // diagrams.cpp
void claims(const All&, lab::Findings&);               // claims.cpp
void fooled(lab::Findings&);                           // fooled.cpp
void sleeping(lab::Findings&);                         // sleeping.cpp
