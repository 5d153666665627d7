// The scenario of tests/capi/same.c, which gives the same hashes in every language.
using System;
using System.Globalization;
using Mimo;

internal static class Same
{
    private static ulong HashOf(ulong hash, byte[] bytes) // FNV-1a
    {
        unchecked
        {
            foreach (var b in bytes) hash = (hash ^ b) * 1099511628211;
        }
        return hash;
    }

    private static void Run(string scene)
    {
        using (var env = new Env(scene))
        {
            var action = new float[env.ActionSize];
            env.Reset(7);
            var hash = HashOf(14695981039346656037, env.Block);
            double sum = 0;
            for (var step = 0; step < 100; ++step)
            {
                for (var i = 0; i < action.Length; ++i) action[i] = ((7 * step + 3 * i) % 21 - 10) / 10.0f;
                sum += env.Step(action).Reward;
                hash = HashOf(hash, env.Block);
            }
            Console.WriteLine(string.Format(CultureInfo.InvariantCulture, "{0} {1:x16} {2:F6}", scene, hash, sum));
        }
    }

    private static void Main()
    {
        foreach (var scene in new[] { "reach", "standup", "selfbody", "benchmark" }) Run(scene);
    }
}
