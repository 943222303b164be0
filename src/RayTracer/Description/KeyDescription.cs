namespace RayTracer.Description;

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
    [Parameter("The value at that time: a number, a list of numbers, or a colour, within the property's range.", IsNumber = true, Required = true)]
    public IReadOnlyList<float> Value { get; init; } = [];

    /// <summary>The way the property changes until the next key.</summary>
    [Parameter("How the value changes until the next key: evenly, slowly at the start and end, or all at once when that key is reached.")]
    public Ease Ease { get; init; } = Ease.Linear;
}
