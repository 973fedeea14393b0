// SPDX-License-Identifier: Apache-2.0
// Calls of functions in expressions: those of the language, the scene's own, splines, and questions about objects.
#include <algorithm>
#include <chrono>
#include <cmath>

#include "fields/noise.h"
#include "import/pov/interpreter_core.h"
#include "import/pov/math_functions.h"

namespace sundog::pov {

double Interpreter::days_since_2000() {
    const auto since_1970 = std::chrono::system_clock::now().time_since_epoch();
    constexpr double kSecondsADay = 86400, kDays1970To2000 = 10957;
    return std::chrono::duration<double>(since_1970).count() / kSecondsADay - kDays1970To2000;
}

/// One argument of a call, and the comma before it unless it is the first.
Value Interpreter::argument(bool first) {
    if (!first && !accept(TokenKind::comma)) {
        if (peek().kind == TokenKind::right_paren) fail_expected("another argument");
        warn_once(here(), "argument comma", "a comma is missing between arguments");
    }
    return parse_expression();
}

Value Interpreter::call_builtin(Keyword keyword, Spot where) {
    const GuardScope no_guard(guard_, {});
    expect(TokenKind::left_paren, "after ", spelling(keyword));
    const Value a = argument(true);
    Value result;
    const auto three = [](const Value& value) { return promoted(value, 3); };
    if (const unsigned arity = float_arity(keyword); arity > 0) {
        const std::array arguments{a.v[0], arity > 1 ? argument(false).v[0] : 0};
        const std::span<const double> used(arguments.data(), arity);
        if (a.count != 1 && !a.is_color) fail(where, std::string(spelling(keyword)) + " is of floats, not of vectors");
        if (outside_domain(keyword, used))
            warn_once(where, "domain" + std::string(spelling(keyword)),
                      std::string(spelling(keyword)) + " has no value there");
        result = number_value(float_function(keyword, used));
    } else {
        switch (keyword) {
            case Keyword::seed:
                // Streams are numbers to the scene; hostile loops shouldn't pile them up without notice.
                tick(1);
                random_streams_.push_back(
                    static_cast<std::uint32_t>(static_cast<std::int64_t>(std::clamp(a.v[0], -9e15, 9e15))));
                result = number_value(static_cast<double>(random_streams_.size() - 1));
                break;
            case Keyword::rand:
                result = number_value(next_random(a.v[0], where));
                break;
            case Keyword::vlength: {
                double sum = 0;
                for (std::uint8_t i = 0; i < a.count; ++i) sum += a.v[i] * a.v[i];
                result = number_value(std::sqrt(a.count == 1 ? 3 * sum : sum));
                break;
            }
            case Keyword::vnormalize: {
                const Value v = three(a);
                const double length = std::sqrt(v.v[0] * v.v[0] + v.v[1] * v.v[1] + v.v[2] * v.v[2]);
                if (length == 0) warn_once(where, "normalize", "vnormalize of a vector of length zero");
                result = length == 0 ? vector_value(0, 0, 0)
                                     : vector_value(v.v[0] / length, v.v[1] / length, v.v[2] / length);
                break;
            }
            case Keyword::vdot: {
                const Value u = three(a), v = three(argument(false));
                result = number_value(u.v[0] * v.v[0] + u.v[1] * v.v[1] + u.v[2] * v.v[2]);
                break;
            }
            case Keyword::vcross: {
                const Value u = three(a), v = three(argument(false));
                result = vector_value(u.v[1] * v.v[2] - u.v[2] * v.v[1], u.v[2] * v.v[0] - u.v[0] * v.v[2],
                                      u.v[0] * v.v[1] - u.v[1] * v.v[0]);
                break;
            }
            case Keyword::vrotate:
                result = rotated(a, argument(false));
                break;
            case Keyword::vaxis_rotate: {
                const Value axis = argument(false);
                result = rotated_about(a, axis, argument(false).v[0]);
                break;
            }
            default: {  // vturbulence(lambda, omega, octaves, point)
                const double omega = argument(false).v[0];
                const double octaves = argument(false).v[0];
                const Value point = three(argument(false));
                const Vec3d offset = fields::turbulence({point.v[0], point.v[1], point.v[2]}, a.v[0], omega, octaves);
                result = vector_value(offset.x, offset.y, offset.z);
            }
        }
    }
    expect(TokenKind::right_paren, "after the arguments of ", spelling(keyword));
    return result;
}

double Interpreter::next_random(double stream, Spot where) {
    if (!(stream >= 0) || stream >= static_cast<double>(random_streams_.size()))
        fail(where, "rand of a stream that seed() didn't give");
    std::uint32_t& state = random_streams_[static_cast<std::size_t>(stream)];
    // A linear congruential generator of full period (Knuth 1981, section 3.2.1); its multiplier is Borosh and
    // Niederreiter's (1983). POV-Ray's rand() prints the same numbers, so that scenes built on them look alike.
    state = state * 1812433253U + 12345U;
    return state / 4294967295.0;
}

Value Interpreter::call_aggregate(Keyword keyword, Spot where) {
    const GuardScope no_guard(guard_, {});
    expect(TokenKind::left_paren, "after ", spelling(keyword));
    std::vector<double> arguments{argument(true).v[0]};
    std::vector<Value> choices;  // select may choose among vectors
    while (peek().kind != TokenKind::right_paren) {
        choices.push_back(argument(false));
        arguments.push_back(choices.back().v[0]);
        if (keyword != Keyword::select) choices.clear();
    }
    take();
    if (keyword != Keyword::select) return number_value(aggregate_function(keyword, arguments));
    if (choices.size() != 2 && choices.size() != 3)
        fail(where, "select takes 3 or 4 arguments, not " + std::to_string(arguments.size()));
    const double a = arguments[0];
    return a < 0 ? choices[0] : choices.size() == 2 || a == 0 ? choices[1] : choices[2];
}

Value Interpreter::call_of_names(Keyword keyword, Spot where) {
    const GuardScope no_guard(guard_, {});
    expect(TokenKind::left_paren, "after ", spelling(keyword));
    double result = 0;
    if (keyword == Keyword::defined) {
        result = raw_is_defined() ? 1 : 0;
    } else {
        const NameId name = raw_name("an array's name");
        const Entity* entity = identifiers_.find(name);
        if (entity == nullptr) fail_undeclared(where, name);
        Entity kept = *entity;
        if (peek_raw_kind() == TokenKind::left_bracket) {
            const auto* outer = std::get_if<std::shared_ptr<Array>>(&kept);
            if (outer != nullptr) kept = element(std::shared_ptr<Array>(*outer), name, where);
        }
        const auto* array = std::get_if<std::shared_ptr<Array>>(&kept);
        if (array == nullptr) fail(where, std::string(names_.text(name)) + " is " + describe(kept) + ", not an array");
        const std::vector<std::uint32_t>& sizes = (*array)->sizes;
        result = static_cast<double>(sizes.size());
        if (keyword == Keyword::dimension_size) {
            expect(TokenKind::comma, "after the array's name");
            const double dimension = parse_number();
            if (!(dimension >= 1) || dimension >= result + 1)
                fail(where, std::string(names_.text(name)) + " has dimensions 1 to " + std::to_string(sizes.size()));
            result = sizes[static_cast<std::size_t>(dimension) - 1];
        }
    }
    expect(TokenKind::right_paren, "after the arguments of ", spelling(keyword));
    return number_value(result);
}

// By value: what the arguments call may declare the name anew.
// NOLINTNEXTLINE(performance-unnecessary-value-param)
Value Interpreter::call_function(std::shared_ptr<const FunctionExpression> function, Spot where) {
    const GuardScope no_guard(guard_, {});
    const Level level(*this);
    take();
    std::vector<double> arguments;
    while (peek().kind != TokenKind::right_paren) {
        const Value value = argument(arguments.empty());
        // A single vector stands for its components where a point is wanted.
        const bool spread = arguments.empty() && value.count > 1 && parameter_count(*function) >= value.count;
        arguments.insert(arguments.end(), value.v.begin(), value.v.begin() + (spread ? value.count : 1));
    }
    take();
    try {
        return function_calls_.call(function, arguments, steps_left_);
    } catch (const FunctionError& error) {
        if (steps_left_ == 0) out_of_steps();
        fail(where, error.what());
    }
}

Value Interpreter::call_spline(const Spline& spline, Spot where) {
    const GuardScope no_guard(guard_, {});
    take();
    const double parameter = parse_number();
    SplineKind kind = spline.kind;
    if (accept(TokenKind::comma)) {
        const auto given =
            peek().kind == TokenKind::keyword ? spline_kind(static_cast<Keyword>(ahead_.payload)) : std::nullopt;
        if (!given) fail_expected("linear_spline, quadratic_spline, cubic_spline or natural_spline");
        kind = *given;
        take();
    }
    expect(TokenKind::right_paren, "after the spline's parameter");
    if (spline.points.empty()) fail(where, "this spline has no points");
    return evaluate(spline, parameter, kind);
}

std::shared_ptr<const Block> Interpreter::object_argument() {
    const Spot where = here();
    if (peek().kind == TokenKind::name) {
        const NameId name = ahead_.payload;
        const Entity* entity = identifiers_.find(name);
        if (entity == nullptr) fail_undeclared(where, name);
        Entity kept = *entity;
        take();
        if (const auto* array = std::get_if<std::shared_ptr<Array>>(&kept);
            array != nullptr && peek().kind == TokenKind::left_bracket)
            kept = element(std::shared_ptr<Array>(*array), name, where);
        if (const auto* group = std::get_if<BlockGroup>(&kept); group != nullptr && !group->empty())
            return group->front();
        fail(where, in_quotes(names_.text(name)) + " is " + describe(kept) + ", not an object");
    }
    if (peek().kind != TokenKind::keyword) fail_expected("an object");
    const auto keyword = static_cast<Keyword>(ahead_.payload);
    take();
    return parse_block(keyword, where);
}

Value Interpreter::call_geometry(Keyword keyword, Spot where) {
    const GuardScope no_guard(guard_, {});
    expect(TokenKind::left_paren, "after ", spelling(keyword));
    const std::shared_ptr<const Block> object = object_argument();
    if (queries_ == nullptr)
        fail(where, std::string(spelling(keyword)) + "() asks about an object's shape, which isn't known here");
    const auto vec = [](const Value& value) {
        const Value v = promoted(value, 3);
        return Vec3d{v.v[0], v.v[1], v.v[2]};
    };
    Value result;
    if (keyword == Keyword::trace) {
        const Vec3d origin = vec(argument(false));
        const Vec3d direction = vec(argument(false));
        GeometryQueries::Hit hit;
        if (length(direction) == 0 || !queries_->trace(object, origin, direction, hit)) hit = {};
        if (accept(TokenKind::comma)) {
            const NameId name = raw_name("an identifier for the normal");
            if (peek_raw_kind() == TokenKind::left_bracket) {
                const std::vector<std::size_t> path = parse_subscripts(name, where);
                element_at(name, path, where) = vector_value(hit.normal.x, hit.normal.y, hit.normal.z);
            } else {
                identifiers_.declare(name) = vector_value(hit.normal.x, hit.normal.y, hit.normal.z);
            }
        }
        result = vector_value(hit.point.x, hit.point.y, hit.point.z);
    } else if (keyword == Keyword::inside) {
        result = number_value(queries_->inside(object, vec(argument(false))) ? 1 : 0);
    } else {
        const Bounds3d bounds = queries_->extent(object);
        const Vec3d corner = keyword == Keyword::min_extent ? bounds.lower : bounds.upper;
        result = vector_value(corner.x, corner.y, corner.z);
    }
    expect(TokenKind::right_paren, "after the arguments of ", spelling(keyword));
    return result;
}

}  // namespace sundog::pov
