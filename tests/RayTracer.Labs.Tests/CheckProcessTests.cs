using System.Text.Json;

namespace RayTracer.Labs.Tests;

/// <summary>How long programs that run checks may take, with programs of the shell in their place.</summary>
public sealed class CheckProcessTests
{
    private static readonly string s_list = Quoted(new[] { new Finding("first", 3), new Finding("second", 4) });
    private static readonly string s_right = Quoted(new Finding("first", 3) { IsRight = true });

    [SkippableFact]
    public void The_start_of_the_runtime_does_not_count_as_the_time_of_a_check() =>
        Assert.Equal([true, true], Run($"sleep 2; echo {s_list}; echo {s_right}; echo {s_right}", seconds: 1).Select(f => f.IsRight));

    [SkippableFact]
    public void A_check_that_takes_too_long_is_the_only_one_that_is_lost()
    {
        IReadOnlyList<Finding> findings = Run($"echo {s_list}; if [ $from = 0 ]; then sleep 60; fi; echo {s_right}", seconds: 1);
        Assert.Equal([false, true], findings.Select(f => f.IsRight));
        Assert.Contains("took longer than 1 seconds", findings[0].Sentence, StringComparison.Ordinal);
    }

    [SkippableFact]
    public void What_cannot_be_started_says_why() =>
        Assert.Equal("the checks could not be started: no such thing", Assert.Throws<LabException>(() => Run("echo no such thing >&2", seconds: 1)).Message);

    private static IReadOnlyList<Finding> Run(string script, int seconds)
    {
        Skip.IfNot(File.Exists("/bin/sh"), "there is no shell");
        return CheckProcess.Run(from => ["/bin/sh", "-c", $"from={from}; {script}"], TimeSpan.FromSeconds(seconds));
    }

    private static string Quoted<T>(T value) => $"'{JsonSerializer.Serialize(value)}'";
}
