using RayTracer.Acceleration;

namespace RayTracer.Rendering;

/// <summary>A tree with which rays find what they meet.</summary>
/// <param name="Holds">What it is built over: "triangles of the world", "triangles of object 1" or "instances".</param>
/// <param name="Statistics">What it looks like, and its memory.</param>
/// <param name="Build">Builds such a tree again, to measure how long that takes; the scene keeps its own.</param>
public sealed record SceneTree(string Holds, BvhStatistics Statistics, Action Build)
{
    /// <summary>Memory of the nodes alone.</summary>
    public long NodeBytes => (long)Statistics.Nodes * BvhNode.Bytes;

    /// <summary>Memory of what the leaves hold.</summary>
    public long LeafBytes => Statistics.MemoryBytes - NodeBytes;
}
