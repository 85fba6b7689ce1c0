#include "tracer/scene/object_names.h"

namespace gnomon {

void UnknownNames::add(const std::string& name, int line, std::string path) {
    const auto [at, isNew] = places_.emplace(name, int(all_.size()));
    if (isNew)
        all_.push_back({name, line, std::move(path)});
    else
        ++all_[std::size_t(at->second)].more;
}

void UnknownNames::report(std::string_view what, const std::vector<std::string_view>& known, const char* remedy,
                          SceneReport& report) const {
    for (const auto& [name, line, path, more] : all_) {
        const std::string others =
            more == 1 ? ", here and in another object" : ", here and in " + std::to_string(more) + " other objects";
        report.add(line, path, "unknown " + std::string(what) + " " + inQuotes(name) + (more > 0 ? others : ""),
                   report.suggest(name, known, remedy));
    }
}

void ObjectNames::name(const ObjectReader& object, int index, std::string& name, SceneReport& report) {
    if (!object.read("name", name)) return;
    const auto [first, isNew] = named_.emplace(name, std::pair(index, object.path()));
    if (!isNew)
        report.add(object.lineOf("name"), object.pathOf("name"),
                   "the name " + inQuotes(name) + " is taken by " + first->second.second, "use each name once");
}

void ObjectNames::resolve(std::vector<Object>& objects, SceneReport& report) const {
    UnknownNames unknown;
    for (const Centre& centre : centres_) {
        const auto found = named_.find(centre.name);
        if (found != named_.end())
            objects[std::size_t(centre.object)].motion->around = found->second.first;
        else
            unknown.add(centre.name, centre.line, centre.path);
    }
    unknown.report("object", namesIn(named_), "give the object a \"name\"", report);
    refuseCircles(objects, report);
}

/// Each circle is reported once, at the first of its objects that the file moves.
void ObjectNames::refuseCircles(const std::vector<Object>& objects, SceneReport& report) const {
    enum class State : char { New, OnTheWay, Done };
    std::vector<State> states(objects.size(), State::New);
    const auto next = [&](int i) {
        const auto& motion = objects[std::size_t(i)].motion;
        return motion ? motion->around : -1;
    };
    for (const Centre& centre : centres_) {
        int i = centre.object;
        for (; i >= 0 && states[std::size_t(i)] == State::New; i = next(i)) states[std::size_t(i)] = State::OnTheWay;
        if (i >= 0 && states[std::size_t(i)] == State::OnTheWay)
            report.add(centre.line, centre.path, inQuotes(centre.name) + " moves around itself in the end",
                       "let one object of the circle rest, or move around none");
        for (i = centre.object; i >= 0 && states[std::size_t(i)] == State::OnTheWay; i = next(i))
            states[std::size_t(i)] = State::Done;
    }
}

} // namespace gnomon
