namespace RayTracer.Session;

/// <summary>An earlier picture, kept for comparison.</summary>
/// <param name="Id">Its number.</param>
/// <param name="Label">What it is, in a few words.</param>
public sealed record Snapshot(int Id, string Label);
