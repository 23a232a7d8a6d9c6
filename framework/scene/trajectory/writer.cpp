// SPDX-License-Identifier: MIT
#include "scene/trajectory/writer.hpp"

#include <bit>

namespace rigor {

static_assert(std::endian::native == std::endian::little, "a trajectory is little-endian");

namespace {

class Writer {
public:
    void raw(const void* data, std::size_t size)
    {
        const std::byte* bytes = static_cast<const std::byte*>(data);
        bytes_.insert(bytes_.end(), bytes, bytes + size);
    }
    template <class T> void put(const T& number)
    {
        static_assert(std::is_arithmetic_v<T>);
        raw(&number, sizeof number);
    }
    void put(const Vector3d& v) { raw(v.data(), sizeof(double) * 3); }
    void put(const Matrix3d& m) { raw(m.data(), sizeof(double) * 9); }
    void put(const std::string& text)
    {
        put(static_cast<std::uint32_t>(text.size()));
        raw(text.data(), text.size());
    }
    Bytes take() { return std::move(bytes_); }
    void reserve(std::size_t more) { bytes_.reserve(bytes_.size() + more); }

private:
    Bytes bytes_;
};

void put_topology(Writer& writer, const SolidTopology& topology)
{
    const EmbeddedSurface& surface = topology.surface;
    for (const std::size_t count : {topology.nodes, topology.elements.size(), surface.points.size(),
                                    surface.triangles.size(), topology.pieces})
        writer.put(static_cast<std::uint32_t>(count));
    for (const std::array<int, 4>& element : topology.elements)
        for (const int node : element)
            writer.put(static_cast<std::int32_t>(node));
    for (const EmbeddedPoint& point : surface.points) {
        writer.put(static_cast<std::int32_t>(point.element));
        for (const double weight : point.weights)
            writer.put(static_cast<float>(weight));
    }
    for (const EmbeddedTriangle& triangle : surface.triangles) {
        for (const int point : triangle.points)
            writer.put(static_cast<std::int32_t>(point));
        writer.put(static_cast<std::int32_t>(triangle.element));
        writer.put(static_cast<std::uint8_t>(triangle.is_crack));
    }
}

void put_solid(Writer& writer, const SolidFrame& solid)
{
    writer.put(static_cast<std::uint8_t>(solid.is_new_topology));
    if (solid.is_new_topology) put_topology(writer, *solid.topology);
    const DeformableTotals& totals = solid.totals;
    for (const double number :
         {totals.mass, totals.volume, totals.kinetic_energy, totals.elastic_energy})
        writer.put(number);
    writer.put(totals.momentum);
    writer.put(totals.angular_momentum);
    writer.put(totals.center_of_mass);
    writer.reserve(48 * solid.positions.size() + 8 * solid.stresses.size());
    for (std::size_t i = 0; i < solid.positions.size(); ++i) {
        writer.put(solid.positions[i]);
        writer.put(solid.velocities[i]);
    }
    for (std::size_t i = 0; i < solid.stresses.size(); ++i) {
        writer.put(solid.stresses[i]);
        writer.put(solid.plastic_strains[i]);
    }
}

} // namespace

Bytes encode_start(const Scene& scene, const std::vector<RecordedBody>& bodies)
{
    Writer writer;
    writer.raw("RIGORTRJ", 8);
    writer.put(std::uint32_t{scene.solids.empty() ? 1U : 2U});
    writer.put(scene.name);
    writer.put(scene.text);
    writer.put(static_cast<std::uint32_t>(bodies.size()));
    for (const RecordedBody& body : bodies) {
        writer.put(static_cast<std::uint8_t>(body.is_static));
        writer.put(body.mass);
        writer.put(body.center_of_mass);
        writer.put(body.inertia);
    }
    if (!scene.solids.empty()) writer.put(static_cast<std::uint32_t>(scene.solids.size()));
    return writer.take();
}

Bytes encode_frame(const Frame& frame)
{
    Writer writer;
    writer.reserve(32 + 104 * frame.bodies.size() + 88 * frame.contacts.size());
    writer.put('F');
    writer.put(frame.step);
    writer.put(frame.time);
    for (const RigidState& state : frame.bodies) {
        writer.put(state.position);
        writer.put(state.orientation.s);
        writer.put(state.orientation.v);
        writer.put(state.velocity);
        writer.put(state.angular_momentum);
    }
    writer.put(static_cast<std::uint32_t>(frame.contacts.size()));
    for (const ContactRecord& contact : frame.contacts) {
        writer.put(static_cast<std::int32_t>(contact.body1));
        writer.put(static_cast<std::int32_t>(contact.body2));
        writer.put(contact.depth);
        writer.put(contact.point);
        writer.put(contact.normal);
        writer.put(contact.impulse);
    }
    for (const SolidFrame& solid : frame.solids)
        put_solid(writer, solid);
    return writer.take();
}

Bytes encode_end(const Counters& counters)
{
    Writer writer;
    writer.put('E');
    writer.put(static_cast<std::uint32_t>(std::size(counter_fields)));
    for (const CounterField& field : counter_fields)
        writer.put(counters.*field.member);
    return writer.take();
}

} // namespace rigor
