using System.Diagnostics;
using System.Reflection;
using System.Text.Json;

namespace RayTracer.Labs;

/// <summary>Runs the checks of a lab within this process.</summary>
internal static class CheckHost
{
    /// <summary>The checks of an assembly, in the order of their sources.</summary>
    /// <param name="lab">The assembly.</param>
    /// <param name="space">The namespace they are in; null for any.</param>
    public static IReadOnlyList<(CheckAttribute Check, MethodInfo Method)> Checks(Assembly lab, string? space = null) =>
    [
        .. lab.GetTypes().Where(t => space is null || t.Namespace == space)
            .SelectMany(t => t.GetMethods(BindingFlags.Public | BindingFlags.Static))
            .Select(m => (Check: m.GetCustomAttribute<CheckAttribute>()!, Method: m))
            .Where(c => c.Check is not null)
            .OrderBy(c => c.Method.MetadataToken),
    ];

    /// <summary>
    /// Runs the checks and writes lines of JSON: first all checks as they are before they have run, then the finding of each as soon as it is there.
    /// </summary>
    /// <param name="path">The assembly.</param>
    /// <param name="student">The student's name.</param>
    /// <param name="from">How many checks to leave out.</param>
    /// <param name="output">Where to write.</param>
    public static void Run(string path, string student, int from, TextWriter output)
    {
        IReadOnlyList<(CheckAttribute Check, MethodInfo Method)> checks = Checks(Assembly.LoadFrom(path));
        output.WriteLine(JsonSerializer.Serialize(checks.Select(c => new Finding(c.Check.Title, c.Check.Points))));
        output.Flush();
        foreach ((CheckAttribute check, MethodInfo method) in checks.Skip(from))
        {
            output.WriteLine(JsonSerializer.Serialize(Run(check, method, student)));
            output.Flush();
        }
    }

    /// <summary>Runs one check.</summary>
    /// <param name="check">The check.</param>
    /// <param name="method">Its method.</param>
    /// <param name="student">The student's name.</param>
    public static Finding Run(CheckAttribute check, MethodInfo method, string student)
    {
        CheckRun run = new(student, check.Title);
        Finding finding = new(check.Title, check.Points) { IsRight = true };
        try
        {
            method.CreateDelegate<Action<CheckRun>>()(run);
        }
        catch (CheckFailedException e)
        {
            finding = e.Finding with { Title = check.Title, Points = check.Points };
        }
        catch (Exception e)
        {
            finding = finding with { IsRight = false, Sentence = Thrown(e) };
        }

        return finding with { Exhibits = [.. run.Exhibits, .. finding.Exhibits] };
    }

    /// <summary>What a student reads of an exception: what was thrown, and the line of the student's code.</summary>
    public static string Thrown(Exception thrown)
    {
        Exception inner = thrown is TypeInitializationException or TargetInvocationException or AggregateException && thrown.InnerException is { } cause ? cause : thrown;
        if (inner is NotImplementedException)
        {
            return $"Not written yet: {inner.Message}";
        }

        StackFrame? frame = new StackTrace(inner, fNeedFileInfo: true).GetFrames().FirstOrDefault(f => f.GetFileName() is not null);
        string at = frame is null ? "" : $" at {Path.GetFileName(frame.GetFileName())}:{frame.GetFileLineNumber()}";
        return $"Your code throws {inner.GetType().Name}{at}: {inner.Message}";
    }
}
