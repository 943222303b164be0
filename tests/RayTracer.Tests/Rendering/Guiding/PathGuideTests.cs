using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Sampling;

namespace RayTracer.Tests.Rendering;

/// <summary>Covers `PathGuide`, `GuideSums`, `DirectionTree` and `GuideMap`.</summary>
public sealed class PathGuideTests
{
    private const int Grid = 128;

    [Fact]
    public void The_density_integrates_to_one_and_is_zero_where_nothing_was_learned()
    {
        PathGuide guide = Learned(0, 1, 2, 3);
        UIntW root = guide.Find(new Vector3(0.3f, 0.3f, 0.3f));
        double sum = 0;
        for (int i = 0; i < Grid * Grid; i += FloatW.Count)
        {
            Place(i, out FloatW u, out FloatW v);
            (FloatW x, FloatW y) = (u, v);
            guide.Descend(root, MaskW.None, ref x, ref y, out FloatW density);
            FloatW stated = guide.Density(root, u, v);
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                sum += density[lane];
                Assert.Equal(density[lane], stated[lane], 1e-5 * density[lane]);
                Assert.Equal((u[lane], v[lane]), (x[lane], y[lane]), (a, b) => Math.Abs(a.Item1 - b.Item1) + Math.Abs(a.Item2 - b.Item2) < 1e-6);
            }
        }

        Assert.Equal(1, sum / (Grid * Grid), 1e-5);
        FloatW none = 0.5f;
        guide.Descend(0u, MaskW.All, ref none, ref none, out FloatW nothing);
        Assert.Equal(0, nothing[0]);
    }

    [Fact]
    public void Directions_are_chosen_with_the_density_that_is_stated()
    {
        const int cells = 16;
        const int samples = 1 << 18;
        PathGuide guide = Learned(0, 1, 2, 3);
        UIntW root = guide.Find(new Vector3(0.3f, 0.3f, 0.3f));
        double[] expected = new double[cells * cells];
        double[] counts = new double[cells * cells];
        static int Cell(float u, float v) => ((int)(v * cells) * cells) + (int)(u * cells);
        for (int i = 0; i < Grid * Grid; i += FloatW.Count)
        {
            Place(i, out FloatW u, out FloatW v);
            guide.Descend(root, MaskW.None, ref u, ref v, out FloatW density);
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                expected[Cell(u[lane], v[lane])] += density[lane] * samples / (Grid * Grid);
            }
        }

        for (int i = 0; i < samples; i += FloatW.Count)
        {
            UIntW number = UIntW.Iota + (uint)i;
            (FloatW u, FloatW v) = (Hash.Mix(number).ToUnit(), Hash.Mix(number + 0x51ED270Bu).ToUnit());
            guide.Descend(root, MaskW.All, ref u, ref v, out FloatW chosen);
            Vec3W direction = GuideMap.ToDirection(u, v);
            GuideMap.ToSquare(direction, out FloatW x, out FloatW y);
            guide.Descend(root, MaskW.None, ref x, ref y, out FloatW stated);
            int same = 0;
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                counts[Cell(u[lane], v[lane])]++;
                same += Math.Abs(chosen[lane] - stated[lane]) <= 1e-5 * chosen[lane] ? 1 : 0;
            }

            // But for borders of cells, across which rounding may carry.
            Assert.True(same >= FloatW.Count - 1);
        }

        ErrorBudget.Warps.Check(PValues.ChiSquared(counts, expected), "directions by a guide");
    }

    [Fact]
    public void Sums_do_not_depend_on_the_order_of_records()
    {
        string[] hashes = [.. new[] { Learned(0, 1, 2, 3), Learned(3, 1, 0, 2) }.Select(g => g.Hash)];
        Assert.Equal(hashes[0], hashes[1]);
        Assert.NotEqual(hashes[0], Learned(0, 1, 2, 2).Hash);
    }

    [Fact]
    public void Space_is_divided_where_there_are_many_records_and_each_place_has_its_own_directions()
    {
        GuideSums sums = new(default, Vector3.One);
        void Fill()
        {
            for (int i = 0; i < 4000; i++)
            {
                bool isLow = i % 2 == 0;
                sums.Add(new(isLow ? 0.1f : 0.9f, 0.5f, 0.5f), 0.3f, isLow ? 0.2f : 0.8f, 100);
            }
        }

        Fill();
        sums = sums.Refined(3000);
        Assert.Equal(2, sums.Leaves);
        Fill();
        PathGuide guide = sums.ToGuide();
        foreach ((float x, float bright) in new[] { (0.1f, 0.2f), (0.9f, 0.8f) })
        {
            (FloatW u, FloatW v) = (0.3f, bright);
            guide.Descend(guide.Find(new Vector3(x, 0.5f, 0.5f)), MaskW.None, ref u, ref v, out FloatW there);
            (u, v) = (0.3f, 1 - bright);
            guide.Descend(guide.Find(new Vector3(x, 0.5f, 0.5f)), MaskW.None, ref u, ref v, out FloatW elsewhere);
            Assert.True(there[0] > 4 && elsewhere[0] == 0, $"{x}: {there[0]} {elsewhere[0]}");
        }
    }

    [Fact]
    public void Tables_that_lead_astray_are_noticed()
    {
        PathGuide guide = Learned(0, 1, 2, 3);
        Assert.True(guide.IsWhole);
        (uint[] space, uint[] nodes) = (guide.Space.ToArray(), guide.Nodes.ToArray());
        foreach ((int at, uint word) in new[] { (PathGuide.NodeWords + PathGuide.FirstChild, 1u), (PathGuide.NodeWords + PathGuide.FirstChild, (uint)nodes.Length), (PathGuide.NodeWords, 0x40000000u) })
        {
            Assert.False(new PathGuide(space, [.. nodes[..at], word, .. nodes[(at + 1)..]]).IsWhole);
        }

        Assert.False(new PathGuide([space[0], 0u, .. space[2..]], nodes).IsWhole);
        Assert.False(new PathGuide([], nodes).IsWhole);
    }

    // Four lots of records, each with light from around a direction of its own, and passes in which the tree grows.
    private static PathGuide Learned(params int[] order)
    {
        GuideSums sums = new(default, Vector3.One);
        for (int pass = 0; pass < 4; pass++)
        {
            foreach (int lot in order)
            {
                for (uint i = 0; i < 500; i++)
                {
                    uint random = Hash.Mix((uint)lot * 1000 + i);
                    (float u, float v) = ((0.2f * lot) + ((random & 0xff) / 2048f), (0.15f * lot) + ((random >> 8 & 0xff) / 4096f));
                    sums.Add(new((random >> 16 & 0xff) / 256f, 0.5f, 0.5f), u, v, 1 + (random >> 24));
                }
            }

            sums = pass == 3 ? sums : sums.Refined(1500);
        }

        return sums.ToGuide();
    }

    private static void Place(int i, out FloatW u, out FloatW v)
    {
        FloatW number = (UIntW.Iota + (uint)i).ToFloat() + 0.5f;
        FloatW row = FloatW.Floor(number * (1f / Grid));
        u = FloatW.NegatedMultiplyAdd(row, Grid, number) * (1f / Grid);
        v = (row + 0.5f) * (1f / Grid);
    }
}
