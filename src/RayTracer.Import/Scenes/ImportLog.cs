using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>Collects what is wrong in a scene of another program.</summary>
internal sealed class ImportLog
{
    // Nobody reads more, and a hostile file could make millions.
    private const int Most = 2000;

    private readonly List<Diagnostic> _diagnostics = [];
    private readonly HashSet<Diagnostic> _said = [];

    /// <summary>The diagnostics so far.</summary>
    public IReadOnlyList<Diagnostic> Diagnostics => _diagnostics;

    /// <summary>Takes an error: the picture would be another one.</summary>
    public void Error(SourcePlace place, string message) => Add(place.At(Severity.Error, message));

    /// <summary>Takes an error, and returns nothing in place of what could not be read.</summary>
    public T? Fail<T>(SourcePlace place, string message)
    {
        Error(place, message);
        return default;
    }

    /// <summary>As the other one, and returns nothing in place of what could not be read.</summary>
    public T? Unknown<T>(SourcePlace place, string message, string word, params string[] known)
    {
        Unknown(place, message, word, known);
        return default;
    }

    /// <summary>True where what is not supported is a warning (<see cref="ImportSettings.IsLenient"/>).</summary>
    public bool IsLenient { get; } = ImportSettings.IsLenient;

    /// <summary>Takes what is not supported: an error, or a warning where something may stand in for it.</summary>
    /// <param name="place">The place.</param>
    /// <param name="message">The message.</param>
    /// <param name="standIn">What stands in for it, as the end of a sentence.</param>
    public void Unsupported(SourcePlace place, string message, string standIn)
    {
        if (IsLenient)
        {
            Warn(place, $"{message}; {standIn}");
        }
        else
        {
            Error(place, message);
        }
    }

    /// <summary>Takes a warning: the picture is right, but something is not as it says there.</summary>
    public void Warn(SourcePlace place, string message) => Add(place.At(Severity.Warning, message));

    /// <summary>Takes an error about a word that is unknown, with the nearest of those that are known, or else all of them.</summary>
    public void Unknown(SourcePlace place, string message, string word, IReadOnlyCollection<string> known) => Error(place, message + Hint(word, known));

    /// <summary>The end of a message about a word that is unknown: the nearest of those that are known, or else all of them.</summary>
    public static string Hint(string word, IReadOnlyCollection<string> known)
    {
        string hint = Spelling.DidYouMean(word, known);
        return hint.Length > 0 || known.Count == 0 ? hint : $": known are {string.Join(", ", known)}";
    }

    private void Add(Diagnostic diagnostic)
    {
        // What is referred to from several places is asked about there.
        if (_diagnostics.Count < Most && _said.Add(diagnostic))
        {
            _diagnostics.Add(diagnostic);
        }
    }
}
