// Custom tasks: their moments and verdicts, their errors, and the threads that they run on.
using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Mimo;

internal static partial class Tests
{
    /// <summary>A task with two terms, a random goal per episode, a success that does not end it, and truncation after
    /// five steps.</summary>
    private sealed class GoalTask : MimoTask
    {
        internal Field Angles;
        internal readonly HashSet<int> Threads = new HashSet<int>();
        internal Action<TaskMoment, TaskVerdict> Err = (moment, verdict) => { };

        public override int Memory => 1;
        public override IReadOnlyList<string> Terms => new[] { "near", "lazy" };
        public override IReadOnlyList<TaskField> Fields => new[]
        {
            new TaskField("goal") { Unit = "rad", Low = -1, High = 1 }, new TaskField("reached", 2)
        };

        public override void Reset(Env world, TaskMoment moment)
        {
            Check(moment.Step == 0 && moment.Action == null && !moment.IsObserved, "a reset has no step");
            Check(moment.Memory[0] == 0 && moment.Fields.All(value => value == 0), "an episode starts from zeros");
            world.Random(moment.Memory);
            moment.Fields[0] = (float)moment.Memory[0];
        }

        public override void Evaluate(Env world, TaskMoment moment, TaskVerdict verdict)
        {
            lock (Threads) Threads.Add(Thread.CurrentThread.ManagedThreadId);
            Check(verdict.Terms.All(value => value == 0) && moment.Fields[0] == (float)moment.Memory[0], "terms start from 0, fields and memory keep their values");
            verdict.Terms[0] = moment.Step;
            if (moment.Action != null) verdict.Terms[1] = -moment.Action[0];
            var angle = new float[1];
            if (moment.IsObserved) moment.Read(Angles, angle);
            moment.Fields[2] = angle[0];
            verdict.Outcome = moment.Step == 2 ? Outcome.Success : Outcome.None;
            verdict.GoesOn = true;
            verdict.Truncated = moment.Step == 5;
            Err(moment, verdict);
        }
    }

    /// <summary>The infant senses only one joint.</summary>
    private static MimoScene SceneWith(GoalTask task)
    {
        var scene = MimoScene.Builtin("free");
        var infant = scene.DefaultAgent();
        infant.Vision = 0;
        infant.Touch = 0;
        scene.AddAgent(infant);
        scene.ReadJoint("robot:left_elbow");
        scene.SetTask(task);
        using (var env = new Env(scene)) task.Angles = env.Layout.Find("proprioception/position");
        return scene;
    }

    private static void CustomTasksRewardAndObserve()
    {
        using (var scene = SceneWith(new GoalTask()))
        using (var env = new Env(scene))
        {
            scene.Dispose();
            GC.Collect(); // only the world refers to the task now
            var goal = env.Layout.Find("goal");
            Check(env.Layout.Terms.Select(term => term.Name).SequenceEqual(new[] { "near", "lazy" }), "names of terms");
            Check(goal.Low == -1 && goal.High == 1, "bounds as declared");
            Check(goal.Unit == "rad" && goal.Shape.SequenceEqual(new[] { 1 }), "the field as declared");
            float[] drawn = new float[1], now = new float[1], reached = new float[2], angle = new float[1];
            env.Reset(4);
            env.Read(goal, drawn);
            Check(drawn[0] > 0 && drawn[0] < 1, "a goal was drawn");
            var action = new float[env.Layout.Actions.Count];
            action[0] = -7; // below the lower bound, -1
            for (var number = 1; number <= 5; ++number)
            {
                var step = env.Step(action);
                Check(step.Reward == number + 1, "the reward is the sum of its terms");
                Check(!step.Terminated && step.Truncated == (number == 5), "success goes on, the fifth step is cut");
                Check(step.Outcome == (number == 2 ? Outcome.Success : Outcome.None), "success");
                Check(env.Terms.SequenceEqual(new double[] { number, 1 }), "terms");
                env.Read(goal, now);
                env.Read(env.Layout.Find("reached"), reached);
                env.Read(env.Layout.Find("proprioception/position"), angle);
                Check(now[0] == drawn[0] && reached[1] == angle[0], "fields");
            }
            using (var twin = env.Clone()) Check(twin.Step(null).Reward == 6, "a clone has the task and its memory");
        }
    }

    private static void ErrorsOfTasksAreReported()
    {
        var task = new GoalTask();
        using (var scene = SceneWith(task))
        using (var env = new Env(scene))
        {
            env.Reset(1);
            task.Err = (moment, verdict) => verdict.Terms[1] = double.NaN;
            Check(Refused(() => env.Step(null)).Message.Contains("the term \"lazy\" as"), "the term is named");
            task.Err = (moment, verdict) => moment.Fields[0] = 2;
            Check(Refused(() => env.Step(null)).Message.Contains("goal[0] as 2, expected a finite number from -1 to 1"), "the field");
            task.Err = (moment, verdict) => { throw new InvalidOperationException("the ball left the table"); };
            var error = Refused(() => env.Step(null));
            Check(error.Status == Status.Task && error.Message.EndsWith("InvalidOperationException: the ball left the table"), error.Message);
            task.Err = (moment, verdict) => env.Find(Kind.Body, "unicorn");
            error = Refused(() => env.Step(null));
            Check(error.Status == Status.Task && error.Message.Contains("(MIMO_E_NOT_FOUND): "), "what failed inside: " + error.Message);
            task.Err = (moment, verdict) => { };
            env.Step(null);
            scene.SetTask(null);
            using (var other = new Env(scene)) Check(other.Step(null).Reward == 0, "the task is taken away");
        }
    }

    private static void StepsWithTask(Batch batch, int worlds, int steps)
    {
        for (var number = 1; number <= steps; ++number)
        {
            batch.Step(null);
            Check(batch.Rewards.All(reward => reward == number), "the rewards of step " + number);
            var expected = number == 2 ? Outcome.Success : Outcome.None;
            Check(Enumerable.Range(0, worlds).All(world => batch.StepOf(world).Outcome == expected), "outcomes of step " + number);
        }
    }

    /// <summary>The collector stops all threads, also threads of the library that run a task.</summary>
    private static void TasksOfBatchesRunOnThreads()
    {
        const int worlds = 8, steps = 40;
        var task = new GoalTask();
        using (var scene = SceneWith(task))
        using (var batch = new Batch(scene, worlds, threads: 2))
        {
            scene.Dispose();
            task.Err = (moment, verdict) =>
            {
                var garbage = new List<byte[]>();
                for (var i = 0; i < 100; ++i) garbage.Add(new byte[1000]);
                verdict.Truncated = garbage.Count == 0;
            };
            var done = false;
            var collector = new Thread(() =>
            {
                while (!Volatile.Read(ref done))
                {
                    GC.Collect();
                    Thread.Sleep(1); // .NET's threads may make no progress between collections without a pause
                }
            });
            batch.Reset(Enumerable.Range(1, worlds).Select(seed => (ulong)seed).ToArray());
            collector.Start();
            try
            {
                StepsWithTask(batch, worlds, steps);
            }
            finally
            {
                Volatile.Write(ref done, true);
                collector.Join();
            }
            Check(task.Threads.Count == 2, task.Threads.Count + " threads");
            for (var world = 0; world < worlds; ++world)
                Check(batch.Terms[2 * world] == steps && batch.Terms[2 * world + 1] == 0, "terms of world " + world);
        }
    }
}
