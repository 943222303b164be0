namespace RayTracer.Description;

/// <summary>The curve of a pixel filter.</summary>
public enum FilterShape
{
    /// <summary>The mean of what the square shows.</summary>
    Box,

    /// <summary>Falls linearly to zero.</summary>
    Tent,

    /// <summary>A bell, lowered so that it ends in zero.</summary>
    Gaussian,

    /// <summary>Mitchell's and Netravali's piecewise cubic curve, with negative lobes that sharpen edges.</summary>
    Mitchell,

    /// <summary>Harris's window of four cosines, a bell without tails.</summary>
    BlackmanHarris,
}

/// <summary>Describes how much the surroundings of a pixel's middle count in its colour: the same curve along and across.</summary>
public sealed record FilterDescription
{
    /// <summary>The curve.</summary>
    [Parameter("The curve: box (sharp squares), tent, gaussian and blackmanHarris (soft bells), or mitchell (sharper, with negative lobes "
        + "beside edges).")]
    public FilterShape Shape { get; init; } = FilterShape.Box;

    /// <summary>The radius at which the curve ends; zero for the usual one.</summary>
    [Parameter("The distance from the pixel's middle at which the curve ends. 0 means the usual one: 0.5 for box, 1 for tent, 1.5 for "
        + "gaussian and blackmanHarris, 2 for mitchell. Of one below 1/64 all samples are taken in the middle.", Unit = "pixels", Minimum = 0, Maximum = 16)]
    public float Radius { get; init; }

    /// <summary>Standard deviation of the bell; zero for a third of the radius.</summary>
    [Parameter("Only for gaussian: standard deviation of the bell. 0 means a third of the radius.",
        Unit = "pixels", Minimum = 0, Maximum = 16)]
    public float Deviation { get; init; }

    /// <summary>Mitchell's and Netravali's B.</summary>
    [Parameter("Only for mitchell: the parameter B, which blurs.", Minimum = 0, Maximum = 1)]
    public float B { get; init; } = 1f / 3;

    /// <summary>Mitchell's and Netravali's C.</summary>
    [Parameter("Only for mitchell: the parameter C, which sharpens and rings.", Minimum = 0, Maximum = 1)]
    public float C { get; init; } = 1f / 3;
}
