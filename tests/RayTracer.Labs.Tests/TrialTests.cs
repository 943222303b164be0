namespace RayTracer.Labs.Tests;

/// <summary>Comparisons in random cases: what is said of a wrong function.</summary>
public class TrialTests
{
    [Fact]
    public void The_simplest_case_is_shown()
    {
        Finding finding = Wrong(new() { Found = x => x.Value > 3.5 ? 0 : x.Value, Expected = x => x.Value });
        Assert.Equal(("x 4, y 0", "4", "0"), (finding.Case, finding.Expected, finding.Found));
        Assert.False(finding.IsRecognised);
    }

    [Fact]
    public void A_mistake_is_named_only_where_it_explains_every_case()
    {
        (string, Func<Number, Answer?>)[] mistakes = [("twice", x => 2 * x.Value), ("half", x => 0.5 * x.Value)];
        Assert.Equal("half", Wrong(new() { Found = x => x.Value / 2, Expected = x => x.Value, Mistakes = mistakes }).Sentence);
        Finding other = Wrong(new() { Found = x => x.Value > 1 ? x.Value / 2 : -1, Expected = x => x.Value, Mistakes = mistakes });
        Assert.Equal(("This is not the right answer.", false), (other.Sentence!, other.IsRecognised));
    }

    [Fact]
    public void What_is_not_a_number_is_wrong_and_nothing_differs_from_something()
    {
        Assert.Equal("NaN", Wrong(new() { Found = _ => double.NaN, Expected = x => x.Value }).Found);
        Assert.Equal("nothing", Wrong(new() { Found = _ => null, Expected = x => x.Value }).Found);
    }

    [Fact]
    public void An_exception_is_told_with_its_case_and_line()
    {
        Finding finding = Wrong(new() { Found = x => throw new InvalidOperationException("oh"), Expected = x => x.Value });
        Assert.Matches(@"^Your code throws InvalidOperationException at TrialTests\.cs:\d+: oh$", finding.Sentence);
        Assert.StartsWith("x ", finding.Case, StringComparison.Ordinal);
    }

    [Fact]
    public void The_numbers_are_those_of_the_name()
    {
        static double First(string student) => new CheckRun(student, "title").Random.Next();
        Assert.Equal(First("Ada"), First("Ada"));
        Assert.NotEqual(First("Ada"), First("Alan"));
    }

    private static Finding Wrong(Draft draft) => Assert.Throws<CheckFailedException>(() => new CheckRun("Ada", "title").Compare(new Trial<Number>
    {
        Draw = d => new(d.Number("x", 0, 10), d.Number("y", -1, 1)),
        Found = draft.Found,
        Expected = draft.Expected,
        Mistakes = draft.Mistakes,
    })).Finding;

    private sealed record Number(double Value, double Other);

    private sealed class Draft
    {
        public required Func<Number, Answer?> Found { get; init; }

        public required Func<Number, Answer?> Expected { get; init; }

        public IReadOnlyList<(string Sentence, Func<Number, Answer?> Answer)> Mistakes { get; init; } = [];
    }
}
