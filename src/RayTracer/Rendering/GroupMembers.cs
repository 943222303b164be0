using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Sorts paths by what they met and is shaded together: the paths of each <see cref="ShadingGroup"/>, and those that met nothing.
/// </summary>
internal sealed unsafe class GroupMembers
{
    private readonly Scene _scene;
    private readonly PinnedBuffer<uint> _members;
    private readonly int _stride;
    private readonly int[] _counts;

    public GroupMembers(Scene scene, int streamSize)
    {
        _scene = scene;
        _counts = new int[scene.Groups.Length + 2];
        _stride = streamSize + (2 * FloatW.Count);
        _members = new((long)_stride * _counts.Length);
    }

    /// <summary>Number of groups; the last but one holds the paths that met nothing, and the last those that a medium scattered.</summary>
    public int Count => _counts.Length;

    /// <summary>Sorts the paths of a stream.</summary>
    public void Sort(PathStream paths)
    {
        Array.Clear(_counts);
        uint* primitive = paths.Primitive;
        uint* members = _members.Pointer;
        nint stride = _stride;
        int pathCount = paths.Count;
        fixed (int* groupOf = _scene.GroupOfPrimitive, counts = _counts)
        {
            for (int i = 0; i < pathCount; i++)
            {
                nint group = groupOf[primitive[i]];
                members[(group * stride) + counts[group]++] = (uint)i;
            }
        }
    }

    /// <summary>Indices of a group's paths in the stream; those behind them, to the end of a packet, repeat a valid one.</summary>
    /// <param name="group">Number of the group.</param>
    /// <param name="count">Number of its paths; where it is 0, there are no indices.</param>
    public uint* Of(int group, out int count)
    {
        count = _counts[group];
        uint* members = _members.Pointer + ((long)group * _stride);
        if (count > 0)
        {
            new Span<uint>(members + count, FloatW.Count).Fill(members[0]);
        }

        return members;
    }
}
