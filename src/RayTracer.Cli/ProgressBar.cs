using Spectre.Console;

namespace RayTracer.Cli;

/// <summary>Progress for terminals: a bar that goes away at the end.</summary>
internal sealed class ProgressBar(TextWriter error) : ProgressDisplay
{
    // Short renderings need no bar, and need not wait until the library that draws it is loaded.
    private const int Delay = 500;
    private const int Interval = 100;

    private protected override void Show()
    {
        if (!Wait(Delay))
        {
            Draw();
        }
    }

    private string Text => Pace.TrimStart(',', ' ');

    private void Draw()
    {
        IAnsiConsole console = AnsiConsole.Create(new() { Out = new AnsiConsoleOutput(error) });
        console.Progress()
            .AutoClear(true)
            .Columns(new ProgressBarColumn(), new PercentageColumn(), new TaskDescriptionColumn())
            .Start(context =>
            {
                ProgressTask task = context.AddTask(Text, maxValue: 1);
                while (!Wait(Interval))
                {
                    task.Value = Fraction;
                    task.Description = Text;
                }
            });
    }
}
