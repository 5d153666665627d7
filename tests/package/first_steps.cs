// What a newcomer does with the package: an infant that moves and senses.
using System;
using Mimo;

internal static class FirstSteps
{
    private static void Main()
    {
        using (var env = new Env("reach"))
        {
            env.Reset(7);
            var action = new float[env.Layout.Actions.Count];
            Step step = env.Step(action);
            for (int i = 0; i < 19; ++i) step = env.Step(action);
            if (step.Terminated) throw new Exception("the infant cannot have reached anything");
            Field position = env.Layout.Find("proprioception/position");
            var angles = new float[position.Shape[0]];
            env.Read(position, angles);
            Console.WriteLine(Library.Version + " " + angles.Length + " " + (Math.Abs(env.Time - 0.2) < 1e-9));
        }
    }
}
