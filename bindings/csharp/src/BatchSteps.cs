using System;

namespace Mimo
{
    /// <summary>Steps of all worlds: at once, or while the caller does something else.</summary>
    public sealed partial class Batch
    {
        /// <summary>Goes one step on in all worlds; worlds x actions, null leaves the controls as they are. The exception is
        /// that of the first world that did not do what was asked; all others have made their step.</summary>
        public void Step(float[] actions)
        {
            MimoException.Check(Native.mimo_batch_step(Handle, actions, Given.LengthOrNone(actions), Blocks, (UIntPtr)Blocks.Length, ref places));
        }

        /// <summary>Starts a step and returns at once. Until Receive the actions are not to be changed, blocks and rewards are
        /// not to be read, and everything else is refused.</summary>
        public void Send(float[] actions)
        {
            var sent = new Pinned(actions);
            var status = Native.mimo_batch_send(Handle, sent.Pointer, sent.Length, blocks, (UIntPtr)Blocks.Length, ref places);
            if (status == 0) Handle.KeepSent(sent);
            else sent.Dispose();
            MimoException.Check(status);
        }

        /// <summary>Waits for the step that was sent. Exceptions are as those of Step.</summary>
        public void Receive() { MimoException.Check(Native.mimo_batch_receive(Handle)); }

        /// <summary>What an agent of a world got in the last step.</summary>
        public Step StepOf(int world, int agent = 0) { return results.Of(Given.Below(world, Worlds, "world") * Layout.Agents + Given.Below(agent, Layout.Agents, "agent")); }

        /// <summary>Whether the last step started a new episode in a world: its block is then the first of that.</summary>
        public bool WasReset(int world) { return wasReset[Given.Below(world, Worlds, "world")] != 0; }

        /// <summary>Whether the last step left a world's last observation of the episode that it ended, with
        /// Autoreset.SameStep.</summary>
        public bool HasFinal(int world) { return finalWritten[Given.Below(world, Worlds, "world")] != 0; }

        /// <summary>Copies a field of that observation into an array of its element type.</summary>
        public void ReadFinal<T>(int world, Field field, T[] into) where T : struct
        {
            if (FinalBlocks == null) throw Given.Refusal("autoreset is not SameStep: there are no last observations of episodes");
            Given.Some(field, "field", "one of Layout.Fields").CopyTo(into, FinalBlocks, StartOf(world));
        }
    }
}
