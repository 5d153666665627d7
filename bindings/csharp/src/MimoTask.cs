using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Mimo
{
    /// <summary>A field of the observation that a task fills, of floats: a goal, and what has been reached of it. Each infant
    /// has one of its own.</summary>
    public sealed class TaskField
    {
        /// <summary>"goal"; no other field of the infant has it.</summary>
        public string Name;
        /// <summary>Dimensions, C order; none: one number.</summary>
        public int[] Shape = new int[0];
        /// <summary>"m"; null for none.</summary>
        public string Unit;
        /// <summary>Frame of reference, "world"; null for none.</summary>
        public string Frame;
        /// <summary>Smallest allowed value.</summary>
        public double Low = double.NegativeInfinity;
        /// <summary>Largest allowed value.</summary>
        public double High = double.PositiveInfinity;

        /// <summary>A field without unit, frame and bounds.</summary>
        public TaskField(string name, params int[] shape)
        {
            Name = name;
            Shape = shape;
        }
    }

    /// <summary>What a task is told: of whom it is asked, and what happened. Good until its method returns.</summary>
    public sealed class TaskMoment
    {
        private IntPtr block;
        private int blockBytes;

        /// <summary>Number of the world in its batch; 0 for a single one.</summary>
        public int World { get; private set; }

        /// <summary>Number of the infant.</summary>
        public int Agent { get; private set; }

        /// <summary>Steps since the reset, with this one; 0 in a reset.</summary>
        public long Step { get; private set; }

        /// <summary>As many numbers as MimoTask.Memory asks for, of this world and infant. They are 0 at the start of an
        /// episode, and part of the world's state.</summary>
        public double[] Memory { get; }

        /// <summary>Values of MimoTask.Fields, one field after the other. They are 0 at the start of an episode, then as last
        /// left, and part of the world's state.</summary>
        public float[] Fields { get; }

        /// <summary>The infant's own actions of this step, within their bounds; null where the step was given none, and in a
        /// reset.</summary>
        public float[] Action { get; private set; }

        /// <summary>Whether there is an observation of this step: not where nobody asks for one, nor in a reset.</summary>
        public bool IsObserved => block != IntPtr.Zero;

        internal TaskMoment(int memory, int fields)
        {
            Memory = new double[memory];
            Fields = new float[fields];
        }

        /// <summary>Copies a field (Layout.Find) out of the observation of this step. Fields of tasks are still those of the
        /// step before.</summary>
        public void Read(Field field, float[] into) { Marshal.Copy(At(field, FieldType.F32, into, 4), into, 0, field.Bytes / 4); }

        /// <summary>The same for a colour picture.</summary>
        public void Read(Field field, byte[] into) { Marshal.Copy(At(field, FieldType.U8, into, 1), into, 0, field.Bytes); }

        private IntPtr At(Field field, FieldType type, Array into, int size)
        {
            if (!IsObserved) throw new InvalidOperationException("there is no observation of this step");
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

    /// <summary>What a task says of a step. Nothing is said at first: no reward, and the episode goes on.</summary>
    public sealed class TaskVerdict
    {
        /// <summary>The reward of a task without terms; of one with terms it stays 0, for the reward is their sum.</summary>
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

    /// <summary>A task of one's own, for MimoScene.SetTask: it runs inside Reset and Step. The worlds of a batch call it at
    /// the same time, on different threads. What it throws is caught; the call that ran it then throws, and quotes
    /// it.</summary>
    public abstract class MimoTask
    {
        /// <summary>How many numbers each world and infant keeps for the task.</summary>
        public virtual int Memory => 0;

        /// <summary>Names of what the reward is the sum of; none: it is one number.</summary>
        public virtual IReadOnlyList<string> Terms => new string[0];

        /// <summary>Further fields of the observation.</summary>
        public virtual IReadOnlyList<TaskField> Fields => new TaskField[0];

        /// <summary>Prepares an episode, in a world that is at its start. The world takes everything but Reset, Step, Load and
        /// Dispose; what it has of an observation is not that of the step.</summary>
        public virtual void Reset(Env world, TaskMoment moment) { }

        /// <summary>Judges a step. Positions of bodies are those of the start of the last physics step. What it writes, to place
        /// the next goal, say, counts from the next step on. Infants are asked in their order.</summary>
        public abstract void Evaluate(Env world, TaskMoment moment, TaskVerdict verdict);
    }
}
