using System.Numerics;
using System.Runtime.InteropServices;
using RayTracer.Acceleration;

namespace RayTracer.Tests.Acceleration;

public sealed unsafe class WideBvhTests
{
    [Theory]
    [InlineData(30_000, 8)]
    [InlineData(30_000, 1)]
    [InlineData(5_000, 4)]
    [InlineData(7, 1)]
    public void The_tree_is_the_same_with_any_number_of_threads(int count, int leafSize)
    {
        float[] bounds = Boxes(count, TestSettings.Seed);
        WideBvh one = WideBvh.Build(bounds, leafSize, 1);
        foreach (int threads in new[] { 2, 3, 7 })
        {
            WideBvh other = WideBvh.Build(bounds, leafSize, threads);
            Assert.Equal(one.Statistics, other.Statistics);
            Assert.True(one.Order.SequenceEqual(other.Order));
            Assert.True(Bytes(one).SequenceEqual(Bytes(other)), $"{threads} threads");
        }
    }

    [Theory]
    [InlineData(0, 8)]
    [InlineData(1, 8)]
    [InlineData(8, 8)]
    [InlineData(9, 8)]
    [InlineData(2_000, 8)]
    [InlineData(2_000, 1)]
    public void Every_primitive_lies_in_one_leaf_within_all_boxes_above_it(int count, int leafSize)
    {
        float[] bounds = Boxes(count, TestSettings.Seed);
        WideBvh tree = WideBvh.Build(bounds, leafSize, 2);
        int[] seen = new int[count];
        Visit(tree, 0, Box4.Empty with { Lower = -Box4.Empty.Lower, Upper = -Box4.Empty.Upper }, bounds, leafSize, seen);
        Assert.All(seen, times => Assert.Equal(1, times));
        Assert.Equal(count, tree.Statistics.Primitives);
        Assert.Equal(tree.Order.ToArray().Order(), Enumerable.Range(0, count));
    }

    [Fact]
    public void Boxes_that_are_none_stay_outside()
    {
        float[] bounds = Boxes(100, 1);
        bounds[6] = float.NaN;
        bounds[15] = float.PositiveInfinity;
        bounds[18] = 2f * bounds[21] + 1f;
        bounds[30] = -1e19f;
        Assert.Equal(96, WideBvh.Build(bounds, 4, 1).Count);
        Assert.Throws<ArgumentException>(() => WideBvh.Build(bounds.AsSpan(1), 4, 1));
        Assert.Throws<ArgumentOutOfRangeException>(() => WideBvh.Build(bounds, 9, 1));
        Assert.Throws<ArgumentOutOfRangeException>(() => WideBvh.Build(bounds, 4, 0));
    }

    [Fact]
    public void Depth_is_bounded_for_boxes_of_all_scales()
    {
        float[] bounds = new float[6 * 5000];
        for (int i = 0; i < 5000; i++)
        {
            float size = MathF.Pow(2f, (i % 100) - 60);
            new float[] { size, size, size, 2f * size, 2f * size, 2f * size }.CopyTo(bounds, 6 * i);
        }

        Assert.InRange(WideBvh.Build(bounds, 1, 1).Statistics.Depth, 4, 46);
    }

    [Fact]
    public void Memory_is_given_back()
    {
        float[] bounds = Boxes(2000, 1);
        long before = NativeMemoryBlock.InUse;
        long taken = 0;
        while (taken < 64 << 20)
        {
            taken += WideBvh.Build(bounds, 1, 1).MemoryBytes;
        }

        // Tests that run beside this one hold trees of their own, for a while.
        bool isGiven = SpinWait.SpinUntil(
            () =>
            {
                GC.Collect();
                GC.WaitForPendingFinalizers();
                return NativeMemoryBlock.InUse - before < taken / 2;
            },
            TimeSpan.FromMinutes(1));
        Assert.True(isGiven, $"of {taken} bytes of trees that nobody has any more, {NativeMemoryBlock.InUse - before} are in use");
    }

    private static ReadOnlySpan<byte> Bytes(WideBvh tree) => new(tree.Nodes, tree.NodeCount * BvhNode.Bytes);

    private static float[] Boxes(int count, int seed)
    {
        TestMesh soup = TestMesh.Soup(count, 0.1f, seed);
        float[] bounds = new float[6 * count];
        Span<Vector3> corners = MemoryMarshal.Cast<float, Vector3>(bounds.AsSpan());
        for (int i = 0; i < count; i++)
        {
            corners[2 * i] = Vector3.Min(soup.Corner(i, 0), Vector3.Min(soup.Corner(i, 1), soup.Corner(i, 2)));
            corners[(2 * i) + 1] = Vector3.Max(soup.Corner(i, 0), Vector3.Max(soup.Corner(i, 1), soup.Corner(i, 2)));
        }

        return bounds;
    }

    private static void Visit(WideBvh tree, uint index, in Box4 box, float[] bounds, int leafSize, int[] seen)
    {
        BvhNode* node = tree.Nodes + index;
        for (int child = 0; child < node->Count; child++)
        {
            Box4 inner = BvhNode.Decode(node, child);
            uint reference = node->Child[child];
            if ((reference & BvhNode.LeafBit) == 0)
            {
                Visit(tree, reference, inner, bounds, leafSize, seen);
                continue;
            }

            Assert.InRange(BvhNode.LeafCount(reference), 1, leafSize);
            for (int i = 0; i < BvhNode.LeafCount(reference); i++)
            {
                int primitive = tree.Order[BvhNode.LeafFirst(reference) + i];
                seen[primitive]++;
                for (int axis = 0; axis < 3; axis++)
                {
                    // Decoding rounds by an ulp; rays allow for more.
                    Assert.InRange(bounds[(6 * primitive) + axis], Math.Max(inner.Lower[axis], box.Lower[axis]) - 1e-6f, float.MaxValue);
                    Assert.InRange(bounds[(6 * primitive) + 3 + axis], float.MinValue, Math.Min(inner.Upper[axis], box.Upper[axis]) + 1e-6f);
                }
            }
        }
    }
}
