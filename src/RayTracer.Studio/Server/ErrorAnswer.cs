namespace RayTracer.Studio;

/// <summary>What a request that is not met is answered with.</summary>
/// <param name="Error">Why, in a sentence for the user.</param>
internal sealed record ErrorAnswer(string Error);
