namespace RayTracer.Session;

/// <summary>What is to be done to a part of a text.</summary>
/// <param name="From">Offset of the part.</param>
/// <param name="To">Offset behind it.</param>
/// <param name="Insert">What takes its place.</param>
public readonly record struct TextEdit(int From, int To, string Insert);
