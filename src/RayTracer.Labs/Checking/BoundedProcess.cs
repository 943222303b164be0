using System.Diagnostics;
using System.Text;

namespace RayTracer.Labs;

/// <summary>A program that is not trusted: what it writes is read as lines, up to a size and a time, and it ends with this object.</summary>
internal sealed class BoundedProcess : IDisposable
{
    private const int MostCharacters = 64 << 20;
    private const int MostOfError = 2000;
    private readonly Process _process;
    private readonly char[] _buffer = new char[1 << 14];
    private readonly StringBuilder _error = new();
    private readonly Task _errors;
    private int _count;
    private int _next;
    private int _read;

    /// <summary>Starts it.</summary>
    /// <param name="command">The program and its arguments.</param>
    /// <param name="variables">Environment variables.</param>
    public BoundedProcess(IReadOnlyList<string> command, params IReadOnlyList<(string Name, string Value)> variables)
    {
        ProcessStartInfo start = new(command[0], command.Skip(1)) { RedirectStandardInput = true, RedirectStandardOutput = true, RedirectStandardError = true, UseShellExecute = false };
        foreach ((string name, string value) in variables)
        {
            start.Environment[name] = value;
        }

        _process = Process.Start(start)!;
        _process.StandardInput.Close();
        _errors = Task.Run(ReadErrors);
    }

    /// <summary>The first line that it wrote to its standard error.</summary>
    public string FirstError
    {
        get
        {
            lock (_error)
            {
                return _error.ToString().TrimStart().Split('\n')[0].TrimEnd();
            }
        }
    }

    /// <summary>Returns the next line; null at the end of what it writes, or if that takes too long, or is too much.</summary>
    /// <param name="end">Until when to wait.</param>
    public string? ReadLine(DateTime end)
    {
        StringBuilder line = new();
        while (true)
        {
            int length = _buffer.AsSpan(_next, _count - _next).IndexOf('\n');
            line.Append(_buffer, _next, length < 0 ? _count - _next : length);
            if (length >= 0)
            {
                _next += length + 1;
                return line.ToString();
            }

            Task<int> more = _process.StandardOutput.ReadAsync(_buffer).AsTask();
            if (!Wait(more, end) || more.Result == 0 || (_read += more.Result) > MostCharacters)
            {
                (_count, _next) = (0, 0);
                return null;
            }

            (_count, _next) = (more.Result, 0);
        }
    }

    /// <summary>Waits for its end; returns its exit status, or null if it had to be ended.</summary>
    /// <param name="end">Until when to wait.</param>
    public int? Finish(DateTime end)
    {
        bool isDone = Wait(_process.WaitForExitAsync(), end) && Wait(_errors, end);
        return isDone ? _process.ExitCode : null;
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        try
        {
            _process.Kill(entireProcessTree: true);
        }
        catch (InvalidOperationException)
        {
            // It has ended already.
        }

        _process.Dispose();
    }

    private static bool Wait(Task task, DateTime end)
    {
        TimeSpan left = end - DateTime.UtcNow;
        return task.Wait(left > TimeSpan.Zero ? left : TimeSpan.Zero);
    }

    private void ReadErrors()
    {
        char[] buffer = new char[1024];
        while (_process.StandardError.Read(buffer) is > 0 and int count)
        {
            lock (_error)
            {
                _error.Append(buffer, 0, Math.Min(count, MostOfError - _error.Length));
            }
        }
    }
}
