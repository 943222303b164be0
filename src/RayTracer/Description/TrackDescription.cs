namespace RayTracer.Description;

/// <summary>The changes of one property of the scene from frame to frame of an animation.</summary>
public sealed record TrackDescription
{
    /// <summary>The path of the property that changes.</summary>
    [Parameter("The numbers that change, by the keys that lead to them: \"camera.position\", \"materials.glass.refractiveIndex\", "
        + "\"shapes[2].radius\" or, for a shape called ball, \"shapes.ball.radius\"; \"shapes.ball.center[1]\" is one of three "
        + "numbers.", Required = true)]
    public string Property { get; init; } = "";

    /// <summary>Its values at certain times.</summary>
    [Parameter("Their values at certain times, in the order of the times. Before the first and after the last one nothing changes.",
        Required = true)]
    public IReadOnlyList<KeyDescription> Keys { get; init; } = [];
}

/// <summary>The way a property changes from one key to the next.</summary>
public enum Ease
{
    /// <summary>In proportion to time.</summary>
    Linear,

    /// <summary>Slowly at first and at last: by 3t² − 2t³.</summary>
    Smooth,

    /// <summary>Not at all until the next key, and then at once.</summary>
    Step,
}

/// <summary>The value of a property at one time.</summary>
public sealed record KeyDescription
{
    /// <summary>The time.</summary>
    [Parameter("The time. Frame n shows the time n / framesPerSecond.", Unit = "seconds", Required = true)]
    public float Time { get; init; }

    /// <summary>The numbers; a single one, or a colour's three, where the property is one.</summary>
    [Parameter("The value at that time: a number, a list of numbers, or a colour, within the property's range.",
        IsNumber = true, Required = true)]
    public IReadOnlyList<float> Value { get; init; } = [];

    /// <summary>The way the property changes until the next key.</summary>
    [Parameter("How the value changes until the next key: evenly, slowly at the start and end, or all at once when that key is reached.")]
    public Ease Ease { get; init; } = Ease.Linear;
}
