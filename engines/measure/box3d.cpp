// Box3D. ENGINE_RULE names what the module was compiled with.

#include <cmath>

#include <box3d/box3d.h>

#include "module.hpp"

namespace engines {

namespace {

b3Vec3 in_box3d(const Vector& v) { return {float(v.x()), float(v.y()), float(v.z())}; }
b3Quat in_box3d(const Quaternion& q) { return {{float(q.x()), float(q.y()), float(q.z())}, float(q.w())}; }
Vector out_of(const b3Vec3& v) { return {double(v.x), double(v.y), double(v.z)}; }

class Box3dWorld : public World {
public:
    Box3dWorld(const Wanted& wanted, int substeps) : wanted_(wanted), substeps_(substeps) {
        b3WorldDef def = b3DefaultWorldDef();
        def.gravity = {0, 0, float(-wanted.gravity)};
        def.enableSleep = wanted.sleeping;
        def.workerCount = 1;
        world_ = b3CreateWorld(&def);
        b3BodyDef ground = b3DefaultBodyDef();
        ground_ = b3CreateBody(world_, &ground);
    }
    ~Box3dWorld() override { b3DestroyWorld(world_); }
    void ground() override {
        b3ShapeDef def = b3DefaultShapeDef();
        def.baseMaterial.friction = float(friction);
        b3BoxHull box = b3MakeOffsetBoxHull(100, 100, 1, {0, 0, -1});
        b3CreateHullShape(ground_, &def, &box.base);
    }
    int add(const Shape& shape, const State& s) override {
        b3BodyDef def = b3DefaultBodyDef();
        def.type = b3_dynamicBody;
        def.allowFastRotation = wanted_.fast;
        def.position = {float(s.x.x()), float(s.x.y()), float(s.x.z())};
        def.rotation = in_box3d(s.q);
        def.linearVelocity = in_box3d(s.v), def.angularVelocity = in_box3d(s.omega);
        def.motionLocks.angularX = shape.locked[0], def.motionLocks.angularY = shape.locked[1];
        def.motionLocks.angularZ = shape.locked[2];
        const b3BodyId body = b3CreateBody(world_, &def);
        b3ShapeDef surface = b3DefaultShapeDef();
        surface.baseMaterial.friction = wanted_.smooth ? 0 : float(friction);
        const b3Vec3 half = in_box3d(shape.half);
        if (shape.kind == Shape::box) {
            b3BoxHull box = b3MakeBoxHull(half.x, half.y, half.z);
            b3CreateHullShape(body, &surface, &box.base);
        } else {
            surface.baseMaterial.rollingResistance = wanted_.smooth ? 0 : float(rolling);
            const b3Capsule capsule = {{0, 0, -half.z}, {0, 0, half.z}, half.x};
            b3CreateCapsuleShape(body, &surface, &capsule);
        }
        b3MassData mass = {float(shape.mass), {0, 0, 0}, {}};
        const timestep::Matrix3<double> turned(shape.axes),
            I = turned * shape.moments.asDiagonal() * turned.transpose();
        mass.inertia = {in_box3d(I.col(0)), in_box3d(I.col(1)), in_box3d(I.col(2))};
        b3Body_SetMassData(body, mass);
        bodies_.push_back(body);
        return int(bodies_.size()) - 1;
    }
    void pin(int a, const Vector& on_a, int b, const Vector& on_b) override {
        b3SphericalJointDef def = b3DefaultSphericalJointDef();
        def.base.bodyIdA = b < 0 ? ground_ : bodies_[std::size_t(b)];
        def.base.bodyIdB = bodies_[std::size_t(a)];
        def.base.localFrameA = {in_box3d(on_b), {{0, 0, 0}, 1}};
        def.base.localFrameB = {in_box3d(on_a), {{0, 0, 0}, 1}};
        b3CreateSphericalJoint(world_, &def);
    }
    void step(double h) override { b3World_Step(world_, float(h), substeps_); }
    State state(int i) const override {
        const b3BodyId body = bodies_[std::size_t(i)];
        const b3Quat q = b3Body_GetRotation(body);
        const b3Pos x = b3Body_GetPosition(body);
        return {Vector(double(x.x), double(x.y), double(x.z)), out_of(b3Body_GetLinearVelocity(body)),
                Quaternion(double(q.s), double(q.v.x), double(q.v.y), double(q.v.z)),
                out_of(b3Body_GetAngularVelocity(body)), !b3Body_IsAwake(body)};
    }

private:
    Wanted wanted_;
    int substeps_;
    b3WorldId world_;
    b3BodyId ground_;
    std::vector<b3BodyId> bodies_;
};

}  // namespace

}  // namespace engines

void timestep_engines(std::vector<engines::Engine>& engines) {
    for (const int substeps : {4, 1, 8})
        engines.push_back({"Box3D, " + std::to_string(substeps) + (substeps == 1 ? " substep" : " substeps"),
                           ENGINE_RULE, [substeps](const engines::Wanted& wanted) {
                               return std::make_unique<engines::Box3dWorld>(wanted, substeps);
                           }});
}
