// A custom task with a goal in the observation: the infant's left hand has to reach a place that is random in each episode.
// The library calls the task within each step, and keeps the goal and the hand's position in the world's state.
//
//   mcs -r:MimoSharp.dll OwnGoal.cs && mono OwnGoal.exe
using System;
using System.Collections.Generic;
using System.Globalization;
using Mimo;

/// <summary>A task with two fields of three numbers, the desired and the achieved goal.</summary>
internal sealed class TouchTheGoal : MimoTask
{
    private const double Near = 0.1; // m
    private static readonly double[] middle = { 0.15, 0.15, 0.3 };

    private readonly int[] hand;

    internal TouchTheGoal(int hand) { this.hand = new[] { hand }; }

    public override IReadOnlyList<string> Terms => new[] { "nearness", "effort" };

    public override IReadOnlyList<TaskField> Fields => new[]
    {
        new TaskField("desired_goal", 3) { Unit = "m", Frame = "world" },
        new TaskField("achieved_goal", 3) { Unit = "m", Frame = "world" }
    };

    public override void Reset(Env world, TaskMoment moment)
    {
        var shares = new double[3];
        world.Random(shares); // from the world's random stream, so that a seed repeats them
        for (var i = 0; i < 3; ++i) moment.Fields[i] = (float)(middle[i] + 0.2 * shares[i] - 0.1);
        Feel(world, moment);
    }

    public override void Evaluate(Env world, TaskMoment moment, TaskVerdict verdict)
    {
        Feel(world, moment);
        double square = 0, effort = 0;
        for (var i = 0; i < 3; ++i) square += Math.Pow(moment.Fields[i] - moment.Fields[3 + i], 2);
        foreach (var action in moment.Action) effort += action * action;
        verdict.Terms[0] = -Math.Sqrt(square);
        verdict.Terms[1] = -0.001 * effort;
        if (Math.Sqrt(square) < Near) verdict.Outcome = Outcome.Success;
        verdict.GoesOn = true; // the episode continues, so that the infant can hold its hand there
        verdict.Truncated = moment.Step == 100;
    }

    /// <summary>Writes the hand's position into the observation.</summary>
    private void Feel(Env world, TaskMoment moment)
    {
        var place = new double[3];
        world.Get(Quantity.BodyPosition, hand, place);
        for (var i = 0; i < 3; ++i) moment.Fields[3 + i] = (float)place[i];
    }
}

internal static class OwnGoal
{
    private static Env MakeWorld()
    {
        using (var scene = MimoScene.Builtin("benchmark"))
        {
            var agent = scene.DefaultAgent();
            agent.Vision = 0;
            agent.Touch = 0;
            scene.AddAgent(agent);
            int hand;
            using (var env = new Env(scene)) hand = env.Find(Kind.Body, "left_hand");
            scene.SetTask(new TouchTheGoal(hand));
            return new Env(scene);
        }
    }

    private static int Main()
    {
        using (var env = MakeWorld())
        {
            Field desired = env.Layout.Find("desired_goal"), achieved = env.Layout.Find("achieved_goal");
            float[] goal = new float[3], place = new float[3], action = new float[env.Layout.Actions.Count];
            env.Reset(1);
            var nearest = double.PositiveInfinity;
            for (var step = new Step(); !step.Truncated;)
            {
                for (var i = 0; i < action.Length; ++i) action[i] = (float)Math.Sin(3 * env.Time + i);
                step = env.Step(action);
                env.Read(desired, goal);
                env.Read(achieved, place);
                double square = 0;
                for (var i = 0; i < 3; ++i) square += Math.Pow(goal[i] - place[i], 2);
                nearest = Math.Min(nearest, Math.Sqrt(square));
            }
            Console.WriteLine(string.Format(CultureInfo.InvariantCulture, "the hand came as near as {0:F2} m", nearest));
            return nearest < 1 ? 0 : 1;
        }
    }
}
