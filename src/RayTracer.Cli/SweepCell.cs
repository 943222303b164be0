namespace RayTracer.Cli;

/// <summary>A place in the grid of a sweep, from 0.</summary>
internal readonly record struct SweepCell(int Column, int Row, int Block);
