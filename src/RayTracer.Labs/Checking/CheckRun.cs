using System.Security.Cryptography;
using System.Text;
using RayTracer.Textbook;

namespace RayTracer.Labs;

/// <summary>What a check works with.</summary>
public sealed class CheckRun
{
    private readonly List<Exhibit> _exhibits = [];

    /// <summary>Begins a check.</summary>
    /// <param name="student">The student's name, which selects the random numbers.</param>
    /// <param name="title">What is checked; another check has other numbers.</param>
    internal CheckRun(string student, string title)
    {
        IndependentSampler random = new(BitConverter.ToInt64(SHA256.HashData(Encoding.UTF8.GetBytes($"{student}\n{title}"))));
        random.Begin(0, 0, 0);
        Random = random;
    }

    /// <summary>Random numbers that are always the same for a student.</summary>
    public ISampler Random { get; }

    /// <summary>What there is to look at.</summary>
    internal IReadOnlyList<Exhibit> Exhibits => _exhibits;

    /// <summary>Compares a function with the truth in random cases.</summary>
    /// <param name="trial">What to compare.</param>
    /// <exception cref="CheckFailedException">They differ.</exception>
    public void Compare<T>(Trial<T> trial)
        where T : class => trial.Run(this);

    /// <summary>Ends the check.</summary>
    /// <param name="sentence">What is wrong, in the words of a student.</param>
    /// <param name="isRecognised">True where it is one of the lab's common mistakes.</param>
    /// <param name="expected">What was expected.</param>
    /// <param name="found">What was found.</param>
    /// <param name="at">The case.</param>
    /// <exception cref="CheckFailedException">Always.</exception>
    public void Fail(string sentence, bool isRecognised = false, string? expected = null, string? found = null, string? at = null) =>
        throw new CheckFailedException(new("", 0) { Sentence = sentence, IsRecognised = isRecognised, Expected = expected, Found = found, Case = at });

    /// <summary>Shows something in the report, whether the check succeeds or not.</summary>
    /// <param name="exhibit">What to show.</param>
    public void Show(Exhibit exhibit) => _exhibits.Add(exhibit);

    /// <summary>Ends the check at the first fact that does not hold.</summary>
    /// <param name="facts">The facts.</param>
    /// <param name="isRecognised">True for sentences that name a common mistake; null for none.</param>
    /// <exception cref="CheckFailedException">One does not hold.</exception>
    public void Require(IEnumerable<Fact> facts, Func<Fact, bool>? isRecognised = null)
    {
        foreach (Fact fact in facts)
        {
            string? Number(double value) => double.IsNaN(value) ? null : Answer.Text(value);
            Exhibit[] drawing = fact.Drawing is { } svg ? [new(fact.Name, "svg", Encoding.UTF8.GetBytes(svg.ToString()))] : [];
            if (!fact.Holds)
            {
                throw new CheckFailedException(new("", 0)
                {
                    Sentence = fact.Sentence.Replace($"Your class threw {nameof(NotImplementedException)}:", "Not written yet:", StringComparison.Ordinal),
                    IsRecognised = isRecognised?.Invoke(fact) == true,
                    Case = fact.Case,
                    Expected = Number(fact.Expected),
                    Found = Number(fact.Found),
                    Exhibits = drawing,
                });
            }

            _exhibits.AddRange(drawing);
        }
    }

    /// <summary>Compares a picture with its reference, and shows both and their difference.</summary>
    /// <param name="width">Width in pixels.</param>
    /// <param name="height">Height in pixels.</param>
    /// <param name="own">The colour of a pixel in the student's picture, by column and row.</param>
    /// <param name="reference">Its colour in the reference.</param>
    /// <param name="mistakes">Mistakes: what is said of each, and its picture.</param>
    /// <exception cref="CheckFailedException">More than a pixel of a thousand differs.</exception>
    public void Compare(
        int width, int height, Func<int, int, Rgb> own, Func<int, int, Rgb> reference, params IReadOnlyList<(string Sentence, Func<int, int, Rgb> Picture)> mistakes)
    {
        Rgb[] Pixels(Func<int, int, Rgb> colour) => [.. Enumerable.Range(0, width * height).Select(i => colour(i % width, i / width))];
        (Rgb[] found, Rgb[] expected) = (Pixels(own), Pixels(reference));
        Show(Pictures.Beside("your picture, the reference, and the difference", width, height, found, expected));
        int[] differing = [.. Enumerable.Range(0, found.Length).Where(i => !Answer.AreNear(found[i], expected[i], 1e-3))];
        if (differing.Length * 1000 > found.Length)
        {
            string? sentence = mistakes.FirstOrDefault(m => Pixels(m.Picture).Zip(found).Count(p => !Answer.AreNear(p.First, p.Second, 1e-3)) * 1000 <= found.Length).Sentence;
            int first = differing[0];
            Fail(
                sentence ?? $"{differing.Length} of {found.Length} pixels have another colour than in the reference.", sentence is not null,
                Answer.Text((Answer)expected[first]), Answer.Text((Answer)found[first]), $"column {first % width}, row {first / width}");
        }
    }
}
