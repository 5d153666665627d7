using System;

namespace Mimo
{
    // What an AgentConfig is made of; values are those of mimo.h.

    /// <summary>Which point of an agent lies at its position.</summary>
    public enum Place
    {
        /// <summary>None: it gets the scene's own place.</summary>
        Scene = 0,
        /// <summary>The origin of its root body; standing soles are 0.33 m below.</summary>
        Root = 1,
        /// <summary>The middle between its feet from above, at the height of the lowest point of them.</summary>
        Soles = 2,
        /// <summary>Its root body from above, at the height of its lowest point.</summary>
        Lowest = 3
    }

    /// <summary>What an agent senses of its own body.</summary>
    [Flags]
    public enum Proprioception : uint
    {
        /// <summary>Nothing.</summary>
        None = 0,
        /// <summary>Joint velocities, rad/s.</summary>
        Velocity = 0x01,
        /// <summary>Three-axis torque sensors at the joints, Nm.</summary>
        Torque = 0x02,
        /// <summary>Limit sensors, 1 at a joint's limit.</summary>
        Limit = 0x04,
        /// <summary>Controls and torques of motors, targets, or what muscles do.</summary>
        Actuation = 0x08,
        /// <summary>Torque about each joint's own axis, Nm.</summary>
        JointTorque = 0x10,
        /// <summary>Joint angles, rad.</summary>
        Position = 0x20,
        /// <summary>Effort, 0 to 1.</summary>
        Effort = 0x40,
        /// <summary>Muscle spindles, Ia, Hz.</summary>
        SpindlePrimary = 0x80,
        /// <summary>Muscle spindles, II, Hz.</summary>
        SpindleSecondary = 0x100,
        /// <summary>Tendon organs, Ib, Hz.</summary>
        TendonOrgan = 0x200,
        /// <summary>Joint receptors near both ends, Hz.</summary>
        JointReceptor = 0x400,
        /// <summary>All that the library has.</summary>
        All = 0x80000000
    }

    /// <summary>Reflexes of newborns.</summary>
    [Flags]
    public enum Reflexes : uint
    {
        /// <summary>None.</summary>
        None = 0,
        /// <summary>Fingers close on what presses on the palm; needs five fingers.</summary>
        PalmarGrasp = 0x1,
        /// <summary>Toes curl under what presses on the ball of the foot.</summary>
        PlantarGrasp = 0x2,
        /// <summary>The head turns to what touches a corner of the mouth.</summary>
        Rooting = 0x4,
        /// <summary>A head that drops: arms open, then close.</summary>
        Moro = 0x8,
        /// <summary>The head turned aside: limbs stretch there, bend opposite.</summary>
        AsymmetricTonicNeck = 0x10,
        /// <summary>Upright on its feet, leaning forward: legs step in turn.</summary>
        Stepping = 0x20,
        /// <summary>Legs draw back from what touches or pricks one.</summary>
        Withdrawal = 0x40,
        /// <summary>The field has all that the body can do; what is not chosen stays 0.</summary>
        Felt = 0x40000000,
        /// <summary>All that this body can do.</summary>
        All = 0x80000000
    }

    /// <summary>What ears tell.</summary>
    [Flags]
    public enum Hearing : uint
    {
        /// <summary>Nothing.</summary>
        None = 0,
        /// <summary>Sound pressure at both ears, Pa.</summary>
        Ears = 0x1,
        /// <summary>Levels in bands above the threshold, dB, and the time between the ears, s.</summary>
        Bands = 0x2
    }

    /// <summary>What the sense of balance feels.</summary>
    [Flags]
    public enum Vestibular : uint
    {
        /// <summary>Nothing.</summary>
        None = 0,
        /// <summary>Acceleration, gravity included, m/s^2.</summary>
        Acceleration = 0x1,
        /// <summary>Angular velocity, rad/s.</summary>
        AngularVelocity = 0x2,
        /// <summary>Six canals, Hz.</summary>
        Canals = 0x4,
        /// <summary>Four maculae, Hz.</summary>
        Otoliths = 0x8,
        /// <summary>Where up is, as it is estimated, m/s^2.</summary>
        Gravity = 0x10
    }

    /// <summary>What a camera or an eye gives.</summary>
    [Flags]
    public enum Vision : uint
    {
        /// <summary>Nothing.</summary>
        None = 0,
        /// <summary>Colour, bytes, height x width x 3, row 0 is the top.</summary>
        Rgb = 0x1,
        /// <summary>Depth along the camera's axis, float, metres.</summary>
        Depth = 0x2,
        /// <summary>Geom id of each pixel, int; -1 is background.</summary>
        Segmentation = 0x4
    }

    /// <summary>What an action is.</summary>
    public enum Actuation
    {
        /// <summary>A motor's share of its largest torque.</summary>
        Torque = 0,
        /// <summary>The angle to which a soft lock takes a joint, rad.</summary>
        Position = 1,
        /// <summary>The activation of a muscle, two a motor, of the original MIMo's model.</summary>
        Muscle = 2,
        /// <summary>The same by MuJoCo's muscle model.</summary>
        MujocoMuscle = 3
    }

    /// <summary>Parts of an infant that have motors; 0: the scene's own choice.</summary>
    [Flags]
    public enum Act : uint
    {
        /// <summary>Three motors.</summary>
        Trunk = 0x01,
        /// <summary>Three.</summary>
        Head = 0x02,
        /// <summary>Three an eye.</summary>
        Eyes = 0x04,
        /// <summary>Shoulder (three) and elbow.</summary>
        RightArm = 0x08,
        /// <summary>The same on the left.</summary>
        LeftArm = 0x10,
        /// <summary>Wrist (three) and fingers.</summary>
        RightHand = 0x20,
        /// <summary>The same on the left.</summary>
        LeftHand = 0x40,
        /// <summary>Hip (three) and knee.</summary>
        RightLeg = 0x80,
        /// <summary>The same on the left.</summary>
        LeftLeg = 0x100,
        /// <summary>Ankle (three) and toes.</summary>
        RightFoot = 0x200,
        /// <summary>The same on the left.</summary>
        LeftFoot = 0x400,
        /// <summary>All that the library has.</summary>
        All = 0x80000000,
        /// <summary>No motor at all; excludes the others.</summary>
        None = 0x40000000
    }

    /// <summary>What skin feels, each a field.</summary>
    [Flags]
    public enum TouchOutputs : uint
    {
        /// <summary>No touch.</summary>
        None = 0,
        /// <summary>"touch/force", N x 3: normal force and friction, N.</summary>
        Force = 0x1,
        /// <summary>"touch/force", N x 1: the normal force alone, N; instead of Force.</summary>
        NormalForce = 0x2,
        /// <summary>"touch/slip", N x 2: how it slides over the skin, along its tangents, m/s.</summary>
        Slip = 0x4,
        /// <summary>"touch/friction_use", N x 1: share of the possible friction in use; 1: all.</summary>
        FrictionUse = 0x8,
        /// <summary>How deep the skin is pressed, Hz.</summary>
        Sa1 = 0x10,
        /// <summary>How fast that changes, Hz.</summary>
        Ra = 0x20,
        /// <summary>Jolts and vibration, Hz.</summary>
        Pc = 0x40,
        /// <summary>Stretch along both tangents, Hz.</summary>
        Sa2 = 0x80,
        /// <summary>Of the skin, degrees Celsius.</summary>
        Temperature = 0x100,
        /// <summary>Cold receptors, Hz.</summary>
        Cold = 0x200,
        /// <summary>Warm receptors, Hz.</summary>
        Warm = 0x400,
        /// <summary>Fast pain, Hz.</summary>
        NociceptionFast = 0x800,
        /// <summary>Slow pain, Hz.</summary>
        NociceptionSlow = 0x1000,
        /// <summary>Afferents that a sensor stands for.</summary>
        Units = 0x2000
    }

    /// <summary>Which touch sensors feel how much of a touch.</summary>
    public enum TouchResponse
    {
        /// <summary>The nearest one feels all of it.</summary>
        Nearest = 1,
        /// <summary>Weights fall linearly with the distance along the skin, to 0 at 2 spacings.</summary>
        Linear = 2,
        /// <summary>Weights fall as a bell of deviation 2/3 spacing, cut off at 2 spacings.</summary>
        Gaussian = 3
    }

    /// <summary>The frame of touch forces with three components.</summary>
    public enum TouchFrame
    {
        /// <summary>That of the body that the sensor sits on.</summary>
        Body = 1,
        /// <summary>That of the world.</summary>
        World = 2,
        /// <summary>Of the skin at the sensor, see Receptor.Frame.</summary>
        Skin = 3
    }
}
