namespace RayTracer.Import;

/// <summary>How scenes of other programs are read, beside what they say themselves.</summary>
public static class ImportSettings
{
    private static readonly IReadOnlyDictionary<string, string> s_none = new Dictionary<string, string>();

    // Of what runs side by side each has its own.
    private static readonly AsyncLocal<bool> s_isLenient = new();
    private static readonly AsyncLocal<IReadOnlyDictionary<string, string>?> s_parameters = new();

    /// <summary>True where what is not supported is a warning, and something that is seen stands in for it.</summary>
    public static bool IsLenient
    {
        get => s_isLenient.Value;
        set => s_isLenient.Value = value;
    }

    /// <summary>Values of parameters of Mitsuba's scenes (<c>$name</c>), which come before those that scenes give them.</summary>
    public static IReadOnlyDictionary<string, string> Parameters
    {
        get => s_parameters.Value ?? s_none;
        set => s_parameters.Value = value;
    }
}
