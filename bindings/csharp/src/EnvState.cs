using System;

namespace Mimo
{
    /// <summary>State, and what differs from world to world: faces, locks, gravity. They outlive resets.</summary>
    public sealed partial class Env
    {
        /// <summary>Everything that the world's future depends on, as bytes.</summary>
        public byte[] Save()
        {
            var state = new byte[StateBytes];
            MimoException.Check(Native.mimo_env_state_save(Handle, state, Given.LengthOf(state, "state")));
            return state;
        }

        internal int StateBytes
        {
            get
            {
                UIntPtr bytes;
                MimoException.Check(Native.mimo_env_state_size(Handle, out bytes));
                return (int)bytes;
            }
        }

        /// <summary>Goes on from a state of a world of the same model, agents and task, exactly as that one did. What it
        /// lacks of a delay starts fresh.</summary>
        public LoadReport Load(byte[] state)
        {
            return LoadReport.Of((ref LoadReportStruct report) =>
                Native.mimo_env_state_load(Handle, state, Given.LengthOf(state, "state"), ref report));
        }

        /// <summary>Another world of the same scene and options, in the same state. The model is shared.</summary>
        public Env Clone()
        {
            EnvHandle clone;
            MimoException.Check(Native.mimo_env_clone(Handle, out clone));
            clone.Log = Handle.Log?.Share();
            clone.Task = Handle.Task?.Share();
            return new Env(clone);
        }

        /// <summary>The face that an infant shows; "" for a body without faces.</summary>
        public string Face(int agent = 0)
        {
            var face = new double[1];
            Get(Quantity.AgentFace, new[] { agent }, face);
            return face[0] < 0 ? "" : Name(Kind.Face, (int)face[0]);
        }

        /// <summary>Gives an infant another face; pictures show it from the next one on.</summary>
        public void SetFace(string name, int agent = 0) { Set(Quantity.AgentFace, new[] { agent }, Find(Kind.Face, name)); }

        /// <summary>Holds a joint (its id) at an angle (rad), softly, from the next step on.</summary>
        public void Lock(int joint, double angle) { Set(Quantity.JointLock, new[] { joint }, 1, angle); }

        /// <summary>Lets a joint go, also one that the scene has locked.</summary>
        public void Unlock(int joint) { Set(Quantity.JointLock, new[] { joint }, 0, LockOf(joint)[1]); }

        /// <summary>The angle at which a joint is held; null if it is not.</summary>
        public double? Locked(int joint)
        {
            var held = LockOf(joint);
            return held[0] != 0 ? held[1] : (double?)null;
        }

        private double[] LockOf(int joint)
        {
            var values = new double[2];
            Get(Quantity.JointLock, new[] { joint }, values);
            return values;
        }

        /// <summary>Gravity, m/s^2, world frame.</summary>
        public Vector3d Gravity
        {
            get { return VectorOf(Get(Quantity.WorldGravity), 0); }
            set { Set(Quantity.WorldGravity, null, value.X, value.Y, value.Z); }
        }
    }
}
