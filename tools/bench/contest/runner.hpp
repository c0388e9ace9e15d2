#pragma once
// How a method on a problem becomes an entry of a contest.

#include <memory>
#include <string>

#include "contest.hpp"

namespace contest {

// A method on a problem. One call of `advance` takes a whole run, so the cost of the call does not count.
class Runner {
public:
    virtual ~Runner() = default;

    // Back to the start, for a run of so many steps.
    virtual void restart(long steps) = 0;
    // Goes n steps on. A method that chooses its own steps goes n marks on.
    virtual void advance(long n) = 0;
    virtual Place place() const = 0;
    // A number that depends on all steps: the result of a timed run.
    virtual double number() const = 0;
    // What a run of so many steps needs.
    virtual Work work(long steps) = 0;
    // Whether the method chooses its own steps.
    virtual bool adaptive() const { return false; }
    // Whether the run cannot go on from where it is: it must begin anew for the next mark.
    virtual bool stuck() const { return false; }
};

Entry make_entry(const std::string& method, const std::string& library, std::unique_ptr<Runner> runner);

}  // namespace contest
