using System;
using System.Collections.Generic;

namespace Mimo
{
    /// <summary>The result of a step for one agent, besides the observation.</summary>
    public struct Step
    {
        /// <summary>Reward of the task.</summary>
        public double Reward;
        /// <summary>The episode ended by success or failure.</summary>
        public bool Terminated;
        /// <summary>The episode was cut off by its step limit or by its task.</summary>
        public bool Truncated;
        /// <summary>Success or failure, also if it does not end the episode.</summary>
        public Outcome Outcome;
    }

    /// <summary>Pinned arrays for the results of steps, of all agents of all worlds.</summary>
    internal sealed class Results
    {
        internal readonly double[] Rewards, Terms;
        private readonly byte[] terminated, truncated;
        private readonly int[] outcomes;

        internal Results(Layout layout, int worlds = 1)
        {
            Rewards = new double[worlds * layout.Agents];
            terminated = new byte[Rewards.Length];
            truncated = new byte[Rewards.Length];
            outcomes = new int[Rewards.Length];
            Terms = new double[worlds * layout.Terms.Count];
        }

        /// <summary>The struct with pointers to the arrays, valid as long as kept.</summary>
        internal EnvResultsStruct PlaceIn(PinnedParts kept)
        {
            return new EnvResultsStruct
            {
                struct_size = EnvResultsStruct.Bytes, reward = kept.Keep(Rewards),
                terminated = kept.Keep(terminated), truncated = kept.Keep(truncated), outcome = kept.Keep(outcomes),
                agent_count = (UIntPtr)Rewards.Length, terms = kept.Keep(Terms), term_count = (UIntPtr)Terms.Length
            };
        }

        internal Step Of(int row)
        {
            return new Step
            {
                Reward = Rewards[row], Terminated = terminated[row] != 0, Truncated = truncated[row] != 0,
                Outcome = (Outcome)outcomes[row]
            };
        }
    }

    /// <summary>The differences between a loaded state and the world: names of sections.</summary>
    public sealed class LoadReport
    {
        /// <summary>Delayed senses and motors of the world that the state lacks: they start fresh.</summary>
        public IReadOnlyList<string> Fresh { get; private set; }

        /// <summary>Sections of the state that the world does not have.</summary>
        public IReadOnlyList<string> Ignored { get; private set; }

        internal delegate int LoadCall(ref LoadReportStruct report);

        internal static LoadReport Of(LoadCall load)
        {
            var raw = LoadReportStruct.New();
            MimoException.Check(load(ref raw));
            return new LoadReport { Fresh = Names(raw.fresh_names), Ignored = Names(raw.ignored_names) };
        }

        private static string[] Names(IntPtr joined)
        {
            return Utf8.Of(joined).Split(new[] { ", " }, StringSplitOptions.RemoveEmptyEntries);
        }
    }
}
