using System;

namespace Mimo
{
    /// <summary>State, and what differs from world to world: faces, locks, gravity. They outlive resets.</summary>
    public sealed partial class Env
    {
        /// <summary>Everything that the world's future depends on, as bytes.</summary>
        public byte[] Save()
        {
            UIntPtr bytes;
            MimoException.Check(Native.mimo_env_state_size(handle, out bytes));
            var state = new byte[(int)bytes];
            MimoException.Check(Native.mimo_env_state_save(handle, state, bytes));
            return state;
        }

        /// <summary>Goes on from a state of a world of the same model, agents and task, exactly as that one did.</summary>
        public void Load(byte[] state)
        {
            MimoException.Check(Native.mimo_env_state_load(handle, state, (UIntPtr)state.Length));
        }

        /// <summary>Another world of the same scene and options, in the same state. The model is shared.</summary>
        public Env Clone()
        {
            EnvHandle clone;
            MimoException.Check(Native.mimo_env_clone(handle, out clone));
            clone.Log = handle.Log?.Share();
            return new Env(clone);
        }

        /// <summary>The face that an infant shows; "" for a body without faces.</summary>
        public string Face(int agent = 0)
        {
            IntPtr name;
            MimoException.Check(Native.mimo_env_face(handle, (UIntPtr)agent, out name));
            return Utf8.Of(name);
        }

        /// <summary>Gives an infant another face; pictures show it from the next one on.</summary>
        public void SetFace(string name, int agent = 0)
        {
            MimoException.Check(Native.mimo_env_set_face(handle, (UIntPtr)agent, Utf8.Bytes(name)));
        }

        /// <summary>Holds a joint (its id) at an angle (rad), softly, from the next step on.</summary>
        public void Lock(int joint, double angle) { MimoException.Check(Native.mimo_env_lock(handle, joint, angle)); }

        /// <summary>Lets a joint go, also one that the scene has locked.</summary>
        public void Unlock(int joint) { MimoException.Check(Native.mimo_env_unlock(handle, joint)); }

        /// <summary>The angle at which a joint is held; null if it is not.</summary>
        public double? Locked(int joint)
        {
            byte locked;
            double angle;
            MimoException.Check(Native.mimo_env_lock_state(handle, joint, out locked, out angle));
            return locked != 0 ? angle : (double?)null;
        }

        /// <summary>Gravity, m/s^2, world frame.</summary>
        public Vector3d Gravity
        {
            get
            {
                Vector3d xyz;
                MimoException.Check(Native.mimo_env_gravity(handle, out xyz, (UIntPtr)3));
                return xyz;
            }
            set { MimoException.Check(Native.mimo_env_set_gravity(handle, value.X, value.Y, value.Z)); }
        }
    }
}
