namespace RayTracer.Session;

/// <summary>Something that takes its time, and can be cancelled.</summary>
/// <param name="Id">Its number.</param>
/// <param name="Text">What is done, in a few words.</param>
/// <param name="Fraction">How far it is, 0 to 1.</param>
public sealed record Job(int Id, string Text, double Fraction);
