using System.Text;

namespace RayTracer.Cli;

/// <summary>
/// Scripts with which shells complete the command's verbs, options and the words that options take; where a value is anything else, they
/// offer files.
/// </summary>
internal static class ShellCompletion
{
    /// <summary>The shells.</summary>
    public static IReadOnlyList<string> Shells { get; } = ["bash", "zsh", "fish", "pwsh"];

    /// <summary>The script for a shell; null for a shell that is not known.</summary>
    public static string? Script(string shell, IReadOnlyList<VerbHelp> verbs) => shell switch
    {
        "bash" => Bash(verbs),
        "zsh" => Zsh(verbs),
        "fish" => Fish(verbs),
        "pwsh" => PowerShell(verbs),
        _ => null,
    };

    private static string Bash(IReadOnlyList<VerbHelp> verbs)
    {
        // Bash takes --tonemap=a for three words, whatever stands before the second.
        StringBuilder text = new($$"""
            # Completion of raytracer for bash: source <(raytracer completion bash)
            _raytracer() {
                local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]} verb=${COMP_WORDS[1]} words=
                COMPREPLY=()
                if [[ $cur == = ]]; then cur=; elif [[ $prev == = ]]; then prev=${COMP_WORDS[COMP_CWORD-2]}; fi
                if [ "$COMP_CWORD" -eq 1 ]; then
                    words='{{Words(First(verbs))}} --help --version'
                else
                    if [ "$COMP_CWORD" -gt 2 ]; then
                        case $verb in {{string.Join('|', Above(verbs))}}) verb="$verb ${COMP_WORDS[2]}" ;; esac
                    fi
                    case "$verb:$prev" in

            """.ReplaceLineEndings("\n"));
        foreach (VerbHelp verb in verbs)
        {
            foreach (OptionHelp option in verb.Options.Where(o => o.Choices.Count > 0))
            {
                text.Append($"            {Patterns(verb, option)}) words='{Words(option.Choices)}' ;;\n");
            }

            // Values that are no words of a list: the shell offers files, where they may be any.
            foreach (OptionHelp option in verb.Options.Where(o => o.Form is not null && o.Choices.Count == 0))
            {
                text.Append(
                    $"            {Patterns(verb, option)}) {(option.TakesFile ? "" : "compopt +o default 2> /dev/null; ")}return ;;\n");
            }
        }

        text.Append("            *) case \"$verb\" in\n");
        foreach (VerbHelp verb in verbs)
        {
            text.Append($"                '{verb.Name}') words='{Words(verb.Choices.Concat(verb.Options.SelectMany(o => o.Names)).Append("--help"))}' ;;\n");
        }

        return text.Append("""
                        esac
                        if [[ $cur != -* ]]; then words=$(for w in $words; do [[ $w == -* ]] || echo "$w"; done); fi ;;
                    esac
                fi
                COMPREPLY=($(compgen -W "$words" -- "$cur"))
            }
            complete -o default -F _raytracer raytracer

            """.ReplaceLineEndings("\n")).ToString();
    }

    private static string Patterns(VerbHelp verb, OptionHelp option) => string.Join('|', option.Names.Select(n => $"'{verb.Name}:{n}'"));

    private static IEnumerable<string> First(IReadOnlyList<VerbHelp> verbs) =>
        verbs.Select(v => v.Name).Where(n => !n.Contains(' ', StringComparison.Ordinal));

    // Verbs with verbs below them.
    private static IEnumerable<string> Above(IReadOnlyList<VerbHelp> verbs) => verbs.Where(v => v.HasVerbs).Select(v => v.Name);

    private static string Zsh(IReadOnlyList<VerbHelp> verbs)
    {
        StringBuilder text = new("#compdef raytracer\n# Completion of raytracer for zsh: source <(raytracer completion zsh)\n_raytracer() {\n    local -a verbs\n    verbs=(\n");
        foreach (VerbHelp verb in verbs.Where(v => First(verbs).Contains(v.Name)))
        {
            text.Append($"        {ZshText($"{verb.Name}:{verb.Summary}")}\n");
        }

        text.Append("    )\n    if (( CURRENT == 2 )); then _describe verb verbs; return; fi\n    local verb=$words[2]\n    shift words; (( CURRENT-- ))\n");
        text.Append($"    case $verb in {string.Join('|', Above(verbs))}) if (( CURRENT > 2 )); then verb=\"$verb $words[2]\"; shift words; (( CURRENT-- )); fi ;; esac\n    case $verb in\n");
        foreach (VerbHelp verb in verbs)
        {
            text.Append($"        '{verb.Name}') _arguments");
            foreach (OptionHelp option in verb.Options)
            {
                string repeated = option.IsRepeatable ? "*" : "";
                string value = option.Form is null ? ""
                    : $":value:{(option.Choices.Count > 0 ? $"({Words(option.Choices)})" : option.TakesFile ? "_files" : " ")}";
                string summary = option.Summary.Replace("[", "(", StringComparison.Ordinal).Replace("]", ")", StringComparison.Ordinal)
                    .Replace(":", "\\:", StringComparison.Ordinal);
                foreach (string name in option.Names)
                {
                    // With "=", the value may be in the next word or behind that sign.
                    string join = option.Form is not null && name.StartsWith("--", StringComparison.Ordinal) ? "=" : "";
                    text.Append($" \\\n            {ZshText($"{repeated}{name}{join}[{summary}]{value}")}");
                }
            }

            text.Append($" \\\n            {(verb.Choices.Count > 0 ? $"'1:word:({Words(verb.Choices)})'" : "'*:file:_files'")} ;;\n");
        }

        return text.Append("    esac\n}\ncompdef _raytracer raytracer\n").ToString();
    }

    private static string ZshText(string text) => $"'{text.Replace("'", "'\\''", StringComparison.Ordinal)}'";

    private static string Fish(IReadOnlyList<VerbHelp> verbs)
    {
        StringBuilder text = new("# Completion of raytracer for fish: raytracer completion fish | source\n");
        foreach (VerbHelp verb in verbs)
        {
            string[] words = verb.Name.Split(' ');
            string seen = $"complete -c raytracer -n '{string.Join("; and ", words.Select(w => $"__fish_seen_subcommand_from {w}"))}";
            seen += verb.HasVerbs ? $"; and not __fish_seen_subcommand_from {Words(verb.Choices)}'" : "'";
            if (words.Length == 1)
            {
                text.Append($"complete -c raytracer -n __fish_use_subcommand -f -a {verb.Name} -d {FishText(verb.Summary)}\n");
            }

            if (verb.Choices.Count > 0)
            {
                text.Append($"{seen} -f -a '{Words(verb.Choices)}'\n");
            }

            foreach (OptionHelp option in verb.Options)
            {
                string names = string.Concat(
                    option.Names.Select(n => n.StartsWith("--", StringComparison.Ordinal) ? $" -l {n[2..]}" : $" -s {n[1..]}"));
                string value = option.Form is null ? ""
                    : option.Choices.Count > 0 ? $" -x -a '{Words(option.Choices)}'" : option.TakesFile ? " -r -F" : " -x";
                text.Append($"{seen}{names}{value} -d {FishText(option.Summary)}\n");
            }
        }

        return text.ToString();
    }

    private static string FishText(string text) =>
        $"'{text.Replace("\\", "\\\\", StringComparison.Ordinal).Replace("'", "\\'", StringComparison.Ordinal)}'";

    private static string PowerShell(IReadOnlyList<VerbHelp> verbs)
    {
        StringBuilder text = new("# Completion of raytracer for PowerShell: raytracer completion pwsh | Out-String | Invoke-Expression\n$raytracerWords = @{\n");
        text.Append($"    '' = '{Words(First(verbs))} --help --version'\n");
        foreach (VerbHelp verb in verbs)
        {
            text.Append($"    '{verb.Name}' = '{Words(verb.Choices.Concat(verb.Options.SelectMany(o => o.Names)).Append("--help"))}'\n");
            foreach (OptionHelp option in verb.Options.Where(o => o.Form is not null))
            {
                foreach (string name in option.Names)
                {
                    text.Append($"    '{verb.Name}:{name}' = '{Words(option.Choices)}'\n");
                }
            }
        }

        return text.Append("""
            }
            Register-ArgumentCompleter -Native -CommandName raytracer -ScriptBlock {
                param($wordToComplete, $commandAst, $cursorPosition)
                $words = @($commandAst.CommandElements | Where-Object { $_.Extent.EndOffset -lt $cursorPosition } | ForEach-Object { $_.ToString() })
                $key = if ($words.Count -lt 2) { '' } else { $words[1] }
                if ($words.Count -gt 2 -and $raytracerWords.ContainsKey("$key $($words[2])")) { $key = "$key $($words[2])" }
                $before = ''
                $sought = $wordToComplete
                if ($wordToComplete -match '^(--[a-z-]+=)(.*)$') {
                    $before = $Matches[1]
                    $sought = $Matches[2]
                    $key = "${key}:$($before.TrimEnd('='))"
                } elseif ($words.Count -gt 2 -and $raytracerWords.ContainsKey("${key}:$($words[-1])")) { $key = "${key}:$($words[-1])" }
                $raytracerWords[$key] -split ' ' | Where-Object { $_ -like "$sought*" -and ($_ -notlike '-*' -or $sought -like '-*') } |
                    ForEach-Object { [System.Management.Automation.CompletionResult]::new("$before$_") }
            }

            """.ReplaceLineEndings("\n")).ToString();
    }

    private static string Words(IEnumerable<string> words) => string.Join(' ', words);
}
