using System;

namespace Mimo
{
    /// <summary>What a step gave an agent, beside the observation.</summary>
    public struct Step
    {
        /// <summary>Reward of the task.</summary>
        public double Reward;
        /// <summary>The episode has ended by success or failure.</summary>
        public bool Terminated;
        /// <summary>The episode is cut off: by its step limit, or by its task.</summary>
        public bool Truncated;
        /// <summary>Success or failure, also where that does not end the episode.</summary>
        public Outcome Outcome;
    }

    /// <summary>Where the library leaves what steps give: arrays of all agents, of all worlds, that stay in place.</summary>
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

        /// <summary>The struct that tells the library where they are; valid as long as what keeps them in place.</summary>
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
}
