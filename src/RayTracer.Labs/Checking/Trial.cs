using System.Diagnostics;

namespace RayTracer.Labs;

/// <summary>
/// Compares a function with the truth in random cases. Where they differ, every number of the case is made simpler as long as they still do
/// (MacIver &amp; Donaldson 2020), and the mistakes are looked through for one that gives what was found.
/// </summary>
/// <typeparam name="T">A case.</typeparam>
public sealed class Trial<T>
    where T : class
{
    /// <summary>Makes a case; null where the numbers make none, as the answer would hang on rounding.</summary>
    public required Func<Draws, T?> Draw { get; init; }

    /// <summary>The function.</summary>
    public required Func<T, Answer?> Found { get; init; }

    /// <summary>The truth.</summary>
    public required Func<T, Answer?> Expected { get; init; }

    /// <summary>Mistakes: what is said of each, and what the function returns that has it. It is named where it explains all cases.</summary>
    public IReadOnlyList<(string Sentence, Func<T, Answer?> Answer)> Mistakes { get; init; } = [];

    /// <summary>What there is to look at, of the smallest case.</summary>
    public Func<T, Exhibit>? Show { get; init; }

    /// <summary>The number of cases.</summary>
    public int Count { get; init; } = 200;

    /// <summary>The largest difference, as for <see cref="Answer.AreNear"/>.</summary>
    public double Tolerance { get; init; } = 1e-6;

    /// <summary>Runs it.</summary>
    /// <exception cref="CheckFailedException">The function is wrong.</exception>
    internal void Run(CheckRun run)
    {
        List<(T Case, Answer? Found)> answers = [];
        Draws? first = null;
        for (int tries = 0; answers.Count < Count && tries < 20 * Count; tries++)
        {
            Draws draws = new(run.Random);
            if (Draw(draws) is { } drawn)
            {
                answers.Add((drawn, Ask(drawn, draws)));
                first ??= Differs(drawn, answers[^1].Found) ? draws : null;
            }
        }

        if (answers.Count == 0)
        {
            throw new InvalidOperationException("no case could be drawn");
        }

        if (first is not null)
        {
            string? sentence = Mistakes.FirstOrDefault(m => answers.TrueForAll(a => Answer.AreNear(a.Found, m.Answer(a.Case), Tolerance))).Sentence;
            throw Failure(Shrink(first, run), sentence);
        }
    }

    private bool Differs(T drawn, Answer? found) => !Answer.AreNear(found, Expected(drawn), Tolerance);

    private Answer? Ask(T drawn, Draws draws)
    {
        try
        {
            return Found(drawn);
        }
        catch (Exception e) when (e is not NotImplementedException)
        {
            throw new CheckFailedException(new("", 0) { Sentence = CheckHost.Thrown(e), Case = draws.Text, Expected = Answer.Text(Expected(drawn)) });
        }
    }

    private Draws Shrink(Draws draws, CheckRun run)
    {
        // A case whose numbers are clamped to their range may be no simpler.
        while (draws.Simpler().Select(numbers => new Draws(run.Random, numbers))
            .FirstOrDefault(d => Draw(d) is { } drawn && d.Complexity < draws.Complexity && Differs(drawn, Ask(drawn, d))) is { } simpler)
        {
            draws = simpler;
        }

        return draws;
    }

    private CheckFailedException Failure(Draws draws, string? sentence)
    {
        T smallest = Draw(new Draws(NoMore.Instance, draws.Numbers)) ?? throw new UnreachableException("the case was drawn before");
        Answer? found = Found(smallest);
        return new(new("", 0)
        {
            Sentence = sentence ?? "This is not the right answer.",
            IsRecognised = sentence is not null,
            Case = draws.Text,
            Expected = Answer.Text(Expected(smallest)),
            Found = Answer.Text(found),
            Exhibits = Show is null ? [] : [Show(smallest)],
        });
    }

    // A case that is drawn again takes no number that it had not before.
    private sealed class NoMore : Textbook.ISampler
    {
        public static NoMore Instance { get; } = new();

        public void Begin(int x, int y, int sample)
        {
        }

        public double Next() => throw new UnreachableException("the case was drawn before");

        public (double U, double V) Next2() => (Next(), Next());
    }
}
