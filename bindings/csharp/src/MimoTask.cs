using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Mimo
{
    /// <summary>A field of floats in the observation that a task fills, such as a goal and what has been reached of it.
    /// Each agent has its own.</summary>
    public sealed class TaskField
    {
        /// <summary>Name, such as "goal"; unique among the agent's fields.</summary>
        public string Name;
        /// <summary>Dimensions, C order; empty: a single number.</summary>
        public int[] Shape = new int[0];
        /// <summary>Unit, such as "m"; null: none.</summary>
        public string Unit;
        /// <summary>Frame of reference, such as "world"; null: none.</summary>
        public string Frame;
        /// <summary>Smallest allowed value.</summary>
        public double Low = double.NegativeInfinity;
        /// <summary>Largest allowed value.</summary>
        public double High = double.PositiveInfinity;

        /// <summary>Makes a field without unit, frame and bounds.</summary>
        public TaskField(string name, params int[] shape)
        {
            Name = name;
            Shape = shape;
        }
    }

    /// <summary>The agent that a task is asked about, and its step. Valid until the method returns.</summary>
    public sealed class TaskMoment
    {
        private IntPtr block;
        private int blockBytes;

        /// <summary>Index of the world in its batch; 0 for a single world.</summary>
        public int World { get; private set; }

        /// <summary>Index of the agent.</summary>
        public int Agent { get; private set; }

        /// <summary>Steps since the reset, including this one; 0 in Reset.</summary>
        public long Step { get; private set; }

        /// <summary>The task's memory for this world and agent, of MimoTask.Memory numbers. It is 0 at the start of an
        /// episode and part of the world's state.</summary>
        public double[] Memory { get; }

        /// <summary>Values of MimoTask.Fields, one field after the other. They are 0 at the start of an episode, keep
        /// their last values, and are part of the world's state.</summary>
        public float[] Fields { get; }

        /// <summary>The agent's actions of this step, within their bounds; null in Reset and in a step without
        /// actions.</summary>
        public float[] Action { get; private set; }

        /// <summary>Whether this step has an observation: false in Reset, and if the caller of the step does not ask
        /// for one.</summary>
        public bool IsObserved => block != IntPtr.Zero;

        internal TaskMoment(int memory, int fields)
        {
            Memory = new double[memory];
            Fields = new float[fields];
        }

        /// <summary>Copies a field (Layout.Find) out of this step's observation. Fields of custom tasks still have the
        /// values of the step before.</summary>
        public void Read(Field field, float[] into) { Marshal.Copy(At(field, FieldType.F32, into, 4), into, 0, field.Bytes / 4); }

        /// <summary>The same for a colour picture.</summary>
        public void Read(Field field, byte[] into) { Marshal.Copy(At(field, FieldType.U8, into, 1), into, 0, field.Bytes); }

        private IntPtr At(Field field, FieldType type, Array into, int size)
        {
            if (!IsObserved) throw new InvalidOperationException("this step has no observation, see TaskMoment.IsObserved");
            if (Given.Some(field, "field", "one of Layout.Fields").Offset + field.Bytes > blockBytes)
                throw Given.Refusal(field.Name + " is a field of another world");
            if (into == null || field.Type != type || into.Length * size < field.Bytes)
                throw Given.Misfit(into, nameof(into), "but " + field.Name + " has " + field.Bytes / size + " elements of type " + field.Type);
            return IntPtr.Add(block, field.Offset);
        }

        internal void Begin(ref TaskMomentStruct told)
        {
            World = (int)told.world;
            Agent = (int)told.agent;
            Step = (long)told.step;
            if (Memory.Length > 0) Marshal.Copy(told.memory, Memory, 0, Memory.Length);
            if (Fields.Length > 0) Marshal.Copy(told.fields, Fields, 0, Fields.Length);
            Action = told.action == IntPtr.Zero ? null : Action ?? new float[(int)told.action_count];
            if (Action != null) Marshal.Copy(told.action, Action, 0, Action.Length);
            block = told.block;
            blockBytes = (int)told.block_bytes;
        }

        internal void End(ref TaskMomentStruct told)
        {
            if (Memory.Length > 0) Marshal.Copy(Memory, 0, told.memory, Memory.Length);
            if (Fields.Length > 0) Marshal.Copy(Fields, 0, told.fields, Fields.Length);
            block = IntPtr.Zero;
        }
    }

    /// <summary>A task's verdict on a step. By default the reward is 0 and the episode continues.</summary>
    public sealed class TaskVerdict
    {
        /// <summary>The reward of a task without terms. With terms leave it 0: the reward is their sum.</summary>
        public double Reward;
        /// <summary>One for each of MimoTask.Terms.</summary>
        public readonly double[] Terms;
        /// <summary>Success, failure or neither.</summary>
        public Outcome Outcome;
        /// <summary>Success or failure does not end the episode.</summary>
        public bool GoesOn;
        /// <summary>The episode is cut off here.</summary>
        public bool Truncated;

        internal TaskVerdict(int terms) { Terms = new double[terms]; }

        internal void Begin()
        {
            Array.Clear(Terms, 0, Terms.Length);
            Reward = 0;
            Outcome = Outcome.None;
            GoesOn = Truncated = false;
        }

        internal void End(ref TaskVerdictStruct told)
        {
            if (Terms.Length > 0) Marshal.Copy(Terms, 0, told.terms, Terms.Length);
            told.reward = Reward;
            told.outcome = (int)Outcome;
            told.goes_on = GoesOn ? 1u : 0u;
            told.truncated = Truncated ? 1u : 0u;
        }
    }

    /// <summary>A custom task for MimoScene.SetTask, which runs inside Reset and Step. The worlds of a batch call it at
    /// the same time on different threads. If it throws, the call that ran it throws a MimoException that quotes the
    /// message.</summary>
    public abstract class MimoTask
    {
        /// <summary>Number of values that the task keeps per world and agent.</summary>
        public virtual int Memory => 0;

        /// <summary>Names of the reward's terms; empty: the reward is a single number.</summary>
        public virtual IReadOnlyList<string> Terms => new string[0];

        /// <summary>Additional fields of the observation.</summary>
        public virtual IReadOnlyList<TaskField> Fields => new TaskField[0];

        /// <summary>Prepares an episode, in a world at its start. All calls on the world are allowed except Reset,
        /// Step, Load and Dispose. The world's Block is not the step's observation.</summary>
        public virtual void Reset(Env world, TaskMoment moment) { }

        /// <summary>Judges a step. Positions of bodies are from the start of the last physics step. Changes to the
        /// world, such as the next goal's position, take effect in the next step. Agents are judged in the order of
        /// their indices.</summary>
        public abstract void Evaluate(Env world, TaskMoment moment, TaskVerdict verdict);
    }
}
