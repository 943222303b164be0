using RayTracer.Rendering;

namespace RayTracer.Tests.Rendering;

/// <summary>The memory of rays around the camera. Covers `EnclosingThing`.</summary>
[Collection(MeasuredMemory.Name)]
public class EnclosingThingTests
{
    [Fact]
    public async Task Memory_that_trees_write_to_is_not_collected_meanwhile()
    {
        Scene scene = TestScenes.Build("""{ "shapes": [{ "type": "mesh", "file": "PATH", "transform": { "scale": 30 } }] }"""
            .Replace("PATH", ProjectFolder.PathOf("scenes", "gallery", "bishop.ply").Replace('\\', '/'), StringComparison.Ordinal));
        using CancellationTokenSource end = new(TimeSpan.FromSeconds(2));
        void Look(int seed)
        {
            for (int i = seed; !end.IsCancellationRequested; i += 131)
            {
                EnclosingThing.IsAround(scene);
                List<int[]> others = [];
                for (int j = 0; j < 30; j++)
                {
                    others.Add(GC.AllocateArray<int>(20 + ((i + (j * 131)) % 900), pinned: true));
                }

                Thread.Yield();
                Assert.All(others, other => Assert.False(other.AsSpan().ContainsAnyExcept(0)));
            }
        }

        void Collect()
        {
            for (; !end.IsCancellationRequested; Thread.Sleep(1))
            {
                GC.Collect(GC.MaxGeneration, GCCollectionMode.Forced, blocking: false);
            }
        }

        Task Long(Action work) => Task.Factory.StartNew(work, TaskCreationOptions.LongRunning);
        await Task.WhenAll([.. Enumerable.Range(0, 8).Select(i => Long(() => Look(i))), Long(Collect)]);
    }
}
