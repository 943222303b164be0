using System.Reflection;
using Xunit.Sdk;

namespace RayTracer.Repository.Tests.Testing;

/// <summary>The suite's probability of a false alarm is bounded by construction.</summary>
public class ErrorBudgetTests
{
    [Fact]
    public void The_shares_of_all_families_add_up_to_the_whole_at_most()
    {
        double sum = ErrorBudget.Families.Sum(f => f.Alpha);
        Assert.True(sum <= ErrorBudget.Whole, $"the shares add up to {sum}");
        Assert.All(ErrorBudget.Families, f => Assert.InRange(f.Level * f.Tests, 0, f.Alpha * (1 + 1e-12)));
    }

    [Fact]
    public void All_families_are_in_the_list_under_names_of_their_own()
    {
        TestFamily[] families =
        [
            .. typeof(ErrorBudget).GetProperties(BindingFlags.Public | BindingFlags.Static)
                .Where(p => p.PropertyType == typeof(TestFamily)).Select(p => (TestFamily)p.GetValue(null)!),
        ];
        Assert.Equal(families.ToHashSet(), ErrorBudget.Families.ToHashSet());
        Assert.Equal(families.Length, ErrorBudget.Families.Count);
        Assert.Distinct(families.Select(f => f.Name));
    }

    [Fact]
    public void A_family_fails_below_its_level_and_for_what_is_not_a_number()
    {
        TestFamily family = new("some", 1e-3, 10, "nothing is wrong");
        Assert.Equal(1e-4, family.Level, 12);
        family.Check(1.001e-4, "just enough");
        string message = Assert.Throws<FailException>(() => family.Check(0.999e-4, "too small")).Message;
        Assert.Contains("too small: p = 9.99E-05, below the level 0.0001 of \"some\" (nothing is wrong)", message, StringComparison.Ordinal);
        Assert.Throws<FailException>(() => family.Check(double.NaN, "no number"));
    }

    [Fact]
    public void A_family_counts_its_p_values_and_fails_when_there_are_too_many()
    {
        TestFamily family = new("few", 1e-3, 3, "nothing is wrong");
        Assert.All(Enumerable.Range(0, 3), i => family.Check(1, $"test {i}"));
        string message = Assert.Throws<FailException>(() => family.Check(1, "the fourth")).Message;
        Assert.Contains("for 3 p-values; this is one more: the fourth", message, StringComparison.Ordinal);
    }

    [Fact]
    public void P_values_that_are_checked_by_many_threads_are_all_counted()
    {
        TestFamily family = new("shared", 1e-3, 10_000, "nothing is wrong");
        Parallel.For(0, 10_000, _ => family.Check(1, "one of many"));
        Assert.Throws<FailException>(() => family.Check(1, "one too many"));
    }
}
