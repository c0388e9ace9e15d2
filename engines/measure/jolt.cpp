// Jolt. ENGINE_RULE names what the module was compiled with.

#include <Jolt/Jolt.h>

#include <Jolt/Core/Factory.h>
#include <Jolt/Core/JobSystemSingleThreaded.h>
#include <Jolt/Core/TempAllocator.h>
#include <Jolt/Physics/Body/BodyCreationSettings.h>
#include <Jolt/Physics/Body/BodyLock.h>
#include <Jolt/Physics/Collision/Shape/BoxShape.h>
#include <Jolt/Physics/Collision/Shape/CapsuleShape.h>
#include <Jolt/Physics/Collision/Shape/PlaneShape.h>
#include <Jolt/Physics/Collision/Shape/RotatedTranslatedShape.h>
#include <Jolt/Physics/Constraints/PointConstraint.h>
#include <Jolt/Physics/PhysicsSystem.h>
#include <Jolt/RegisterTypes.h>

#include "module.hpp"

namespace engines {

namespace {

JPH::Vec3 in_jolt(const Vector& v) { return {float(v.x()), float(v.y()), float(v.z())}; }
JPH::Quat in_jolt(const Quaternion& q) { return {float(q.x()), float(q.y()), float(q.z()), float(q.w())}; }
Vector out_of(JPH::Vec3Arg v) { return {double(v.GetX()), double(v.GetY()), double(v.GetZ())}; }

// Everything may touch everything.
struct Layers : JPH::BroadPhaseLayerInterface {
    JPH::uint GetNumBroadPhaseLayers() const override { return 1; }
    JPH::BroadPhaseLayer GetBroadPhaseLayer(JPH::ObjectLayer) const override { return JPH::BroadPhaseLayer(0); }
};

// Jolt's own order: once in a program.
void start_jolt() {
    static const bool started = [] {
        JPH::RegisterDefaultAllocator();
        JPH::Factory::sInstance = new JPH::Factory();
        JPH::RegisterTypes();
        return true;
    }();
    (void)started;
}

class JoltWorld : public World {
public:
    JoltWorld(const Wanted& wanted, bool gyroscopic)
        : wanted_(wanted), gyroscopic_(gyroscopic), memory_(8 << 20), jobs_(JPH::cMaxPhysicsJobs) {
        system_.Init(2048, 0, 8192, 4096, layers_, every_layer_, every_pair_);
        system_.SetGravity({0, 0, float(-wanted.gravity)});
    }
    void ground() override {
        const JPH::PlaneShapeSettings plane(JPH::Plane(JPH::Vec3(0, 0, 1), 0), nullptr, 100);
        JPH::BodyCreationSettings settings(plane.Create().Get(), JPH::RVec3::sZero(), JPH::Quat::sIdentity(),
                                           JPH::EMotionType::Static, 0);
        settings.mFriction = float(friction);
        system_.GetBodyInterface().CreateAndAddBody(settings, JPH::EActivation::DontActivate);
    }
    int add(const Shape& shape, const State& s) override {
        JPH::RefConst<JPH::Shape> solid;
        const JPH::Vec3 half = in_jolt(shape.half);
        if (shape.kind == Shape::box) {
            solid = new JPH::BoxShape(half, std::min(0.05f, half.ReduceMin() / 2));
        } else {  // Jolt's capsules lie along y
            const JPH::Quat turned = JPH::Quat::sRotation(JPH::Vec3::sAxisX(), 0.5f * JPH::JPH_PI);
            solid = new JPH::RotatedTranslatedShape(JPH::Vec3::sZero(), turned,
                                                    new JPH::CapsuleShape(half.GetZ(), half.GetX()));
        }
        JPH::BodyCreationSettings settings(solid, in_jolt(s.x), in_jolt(s.q), JPH::EMotionType::Dynamic, 0);
        settings.mLinearVelocity = in_jolt(s.v), settings.mAngularVelocity = in_jolt(s.omega);
        settings.mFriction = wanted_.smooth ? 0 : float(friction);
        settings.mApplyGyroscopicForce = gyroscopic_ && wanted_.rule;
        settings.mAllowSleeping = wanted_.sleeping;
        constexpr JPH::EAllowedDOFs about[] = {JPH::EAllowedDOFs::RotationX, JPH::EAllowedDOFs::RotationY,
                                               JPH::EAllowedDOFs::RotationZ};
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (shape.locked[axis]) settings.mAllowedDOFs &= ~about[axis];
        if (!wanted_.damping) settings.mLinearDamping = settings.mAngularDamping = 0;
        settings.mOverrideMassProperties = JPH::EOverrideMassProperties::MassAndInertiaProvided;
        settings.mMassPropertiesOverride.mMass = float(shape.mass);
        const bool finite = shape.moments.allFinite();
        const JPH::Mat44 turned = JPH::Mat44::sRotation(in_jolt(shape.axes));
        settings.mMassPropertiesOverride.mInertia =
            turned * JPH::Mat44::sScale(finite ? in_jolt(shape.moments) : JPH::Vec3::sOne()) * turned.Transposed();
        bodies_.push_back(system_.GetBodyInterface().CreateAndAddBody(settings, JPH::EActivation::Activate));
        if (!finite) {
            const JPH::BodyLockWrite body(system_.GetBodyLockInterface(), bodies_.back());
            body.GetBody().GetMotionProperties()->SetInverseInertia(in_jolt(shape.moments.cwiseInverse()),
                                                                    in_jolt(shape.axes));
        }
        return int(bodies_.size()) - 1;
    }
    void pin(int a, const Vector& on_a, int b, const Vector& on_b) override {
        JPH::PointConstraintSettings settings;
        settings.mSpace = JPH::EConstraintSpace::LocalToBodyCOM;
        settings.mPoint1 = in_jolt(on_b), settings.mPoint2 = in_jolt(on_a);
        JPH::BodyInterface& bodies = system_.GetBodyInterface();
        const JPH::BodyID one = b < 0 ? JPH::BodyID() : bodies_[std::size_t(b)];
        system_.AddConstraint(bodies.CreateConstraint(&settings, one, bodies_[std::size_t(a)]));
    }
    void step(double h) override { system_.Update(float(h), 1, &memory_, &jobs_); }
    State state(int i) const override {
        const JPH::BodyInterface& bodies = system_.GetBodyInterfaceNoLock();
        const JPH::BodyID body = bodies_[std::size_t(i)];
        const JPH::Quat q = bodies.GetRotation(body);
        return {out_of(JPH::Vec3(bodies.GetCenterOfMassPosition(body))), out_of(bodies.GetLinearVelocity(body)),
                Quaternion(double(q.GetW()), double(q.GetX()), double(q.GetY()), double(q.GetZ())),
                out_of(bodies.GetAngularVelocity(body)), !bodies.IsActive(body)};
    }

private:
    Wanted wanted_;
    bool gyroscopic_;
    JPH::TempAllocatorImpl memory_;
    JPH::JobSystemSingleThreaded jobs_;
    Layers layers_;
    JPH::ObjectVsBroadPhaseLayerFilter every_layer_;
    JPH::ObjectLayerPairFilter every_pair_;
    JPH::PhysicsSystem system_;
    std::vector<JPH::BodyID> bodies_;
};

}  // namespace

}  // namespace engines

void timestep_engines(std::vector<engines::Engine>& engines) {
    const auto enter = [&](const std::string& rule, bool gyroscopic) {
        engines.push_back({"Jolt", rule, [gyroscopic](const engines::Wanted& wanted) {
                               engines::start_jolt();
                               return std::make_unique<engines::JoltWorld>(wanted, gyroscopic);
                           }});
    };
    if (std::string(ENGINE_RULE) == "as it is") enter("without its rule", false);
    enter(ENGINE_RULE, true);
}
