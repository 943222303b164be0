using RayTracer.Rendering;
using RayTracer.Session;

namespace RayTracer.Session.Tests;

public sealed class SlicePlanTests
{
    [Theory]
    [InlineData(100, 75, 1, 0.0001)]
    [InlineData(100, 75, 1000, 0.0001)]
    [InlineData(640, 480, 37, 0.3)]
    [InlineData(640, 481, 3, 7.0)]
    [InlineData(1, 1, 65, 20)]
    public void Slices_cover_every_sample_of_every_pixel_once(int width, int height, int samples, double secondsPerSample)
    {
        SlicePlan plan = new(new(5, 7, width, height), samples);
        int[,] counts = new int[height, samples];
        double seconds = 0;
        while (!plan.IsDone)
        {
            Slice slice = plan.Next(seconds, secondsPerSample);
            Assert.Equal((5, width), (slice.Area.X, slice.Area.Width));
            for (int y = slice.Area.Y; y < slice.Area.Y + slice.Area.Height; y++)
            {
                for (int s = slice.Samples.First; s < slice.Samples.End; s++)
                {
                    counts[y - 7, s]++;
                }
            }

            seconds += secondsPerSample * slice.Samples.Count * slice.Area.Height / height;
            plan.Add(slice);
        }

        Assert.All(counts.Cast<int>(), c => Assert.Equal(1, c));
    }

    [Fact]
    public void Slices_end_at_every_power_of_two()
    {
        SlicePlan plan = new(new(0, 0, 10, 10), 300);
        List<int> ends = [];
        while (!plan.IsDone)
        {
            plan.Add(plan.Next(100, 1e-9));
            ends.Add(plan.Samples);
        }

        Assert.All(new[] { 1, 2, 4, 8, 16, 32, 64, 128, 256, 300 }, end => Assert.Contains(end, ends));
    }

    [Fact]
    public void The_work_goes_on_with_more_samples_where_it_was()
    {
        SlicePlan plan = new(new(0, 0, 10, 10), 4);
        while (!plan.IsDone)
        {
            plan.Add(plan.Next(0, 1));
        }

        SlicePlan more = plan.WithSamples(9);
        Assert.Equal(new SampleRange(4, 5), more.Next(0, 1).Samples);
    }
}
