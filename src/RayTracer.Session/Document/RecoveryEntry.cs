namespace RayTracer.Session;

/// <summary>A text that was not saved when a session ended.</summary>
/// <param name="Id">How it is asked for.</param>
/// <param name="Name">What the document was called.</param>
/// <param name="Time">When it was kept.</param>
public sealed record RecoveryEntry(string Id, string Name, DateTime Time);
