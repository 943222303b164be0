namespace RayTracer.Description;

/// <summary>The changes of one property of the scene from frame to frame of an animation.</summary>
public sealed record TrackDescription
{
    /// <summary>The path of the property that changes.</summary>
    [Parameter("The numbers that change, by the keys that lead to them: \"camera.position\", \"materials.glass.refractiveIndex\", \"shapes[2].radius\" or, for a shape called ball, \"shapes.ball.radius\"; \"shapes.ball.center[1]\" is one of three numbers.", Required = true)]
    public string Property { get; init; } = "";

    /// <summary>Its values at certain times.</summary>
    [Parameter("Their values at certain times, in the order of the times. Before the first and after the last one nothing changes.", Required = true)]
    public IReadOnlyList<KeyDescription> Keys { get; init; } = [];
}
