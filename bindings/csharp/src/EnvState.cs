using System;

namespace Mimo
{
    /// <summary>Saved states, and values that differ between worlds and survive resets: faces, locks,
    /// gravity.</summary>
    public sealed partial class Env
    {
        /// <summary>The world's state as bytes: everything that determines its future.</summary>
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

        /// <summary>Loads a state of a world of the same model, agents and task. This world then continues exactly as
        /// that one did. Delays that the state lacks start fresh.</summary>
        public LoadReport Load(byte[] state)
        {
            return LoadReport.Of((ref LoadReportStruct report) =>
                Native.mimo_env_state_load(Handle, state, Given.LengthOf(state, "state"), ref report));
        }

        /// <summary>Makes another world of the same scene and config in the same state. Both share the model.</summary>
        public Env Clone()
        {
            EnvHandle clone;
            MimoException.Check(Native.mimo_env_clone(Handle, out clone));
            clone.Log = Handle.Log?.Share();
            clone.Task = Handle.Task?.Share();
            return new Env(clone);
        }

        /// <summary>An infant's face; "" for a body without faces.</summary>
        public string Face(int agent = 0)
        {
            var face = new double[1];
            Get(Quantity.AgentFace, new[] { agent }, face);
            return face[0] < 0 ? "" : Name(Kind.Face, (int)face[0]);
        }

        /// <summary>Sets an infant's face, which the next picture shows.</summary>
        public void SetFace(string name, int agent = 0) { Set(Quantity.AgentFace, new[] { agent }, Find(Kind.Face, name)); }

        /// <summary>Holds a joint (by id) softly at an angle (rad) from the next step on.</summary>
        public void Lock(int joint, double angle) { Set(Quantity.JointLock, new[] { joint }, 1, angle); }

        /// <summary>Releases a joint, also one that the scene locked.</summary>
        public void Unlock(int joint) { Set(Quantity.JointLock, new[] { joint }, 0, LockOf(joint)[1]); }

        /// <summary>The angle at which a joint is locked; null if it is free.</summary>
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
