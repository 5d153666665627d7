using System;

namespace Mimo
{
    /// <summary>Steps of all worlds, synchronous or in the background.</summary>
    public sealed partial class Batch
    {
        /// <summary>Steps all worlds. actions is worlds x actions; null keeps the controls. If a world fails, the
        /// others still make their step, and the exception is the one of the first world that failed.</summary>
        public void Step(float[] actions)
        {
            MimoException.Check(Native.mimo_batch_step(Handle, actions, Given.LengthOrNone(actions), Blocks, (UIntPtr)Blocks.Length, ref places));
        }

        /// <summary>Starts a step and returns at once. Until Receive do not change the actions and do not read blocks
        /// or rewards; all other calls are refused.</summary>
        public void Send(float[] actions)
        {
            var sent = new Pinned(actions);
            var status = Native.mimo_batch_send(Handle, sent.Pointer, sent.Length, blocks, (UIntPtr)Blocks.Length, ref places);
            if (status == 0) Handle.KeepSent(sent);
            else sent.Dispose();
            MimoException.Check(status);
        }

        /// <summary>Waits for the end of the step that Send started. Throws what Step would throw.</summary>
        public void Receive() { MimoException.Check(Native.mimo_batch_receive(Handle)); }

        /// <summary>The result of the last step for an agent of a world.</summary>
        public Step StepOf(int world, int agent = 0) { return results.Of(Given.Below(world, Worlds, "world") * Layout.Agents + Given.Below(agent, Layout.Agents, "agent")); }

        /// <summary>Whether the last step started a new episode in a world. The world's block is then the first one of
        /// that episode.</summary>
        public bool WasReset(int world) { return wasReset[Given.Below(world, Worlds, "world")] != 0; }

        /// <summary>Whether the last step ended an episode of a world and kept its last observation, with
        /// Autoreset.SameStep.</summary>
        public bool HasFinal(int world) { return finalWritten[Given.Below(world, Worlds, "world")] != 0; }

        /// <summary>Copies a field of an episode's last observation into an array of its element type.</summary>
        public void ReadFinal<T>(int world, Field field, T[] into) where T : struct
        {
            if (FinalBlocks == null) throw Given.Refusal("autoreset is not SameStep: the last observations of episodes are not kept");
            Given.Some(field, "field", "one of Layout.Fields").CopyTo(into, FinalBlocks, StartOf(world));
        }
    }
}
